// What the core says of queries [{eye, lens, targets: [[azimuth_rad, elevation_rad, distance_m or "inf"]]}]: [[EllipseNumbers]]. In node and in a page.
function answers(core, queries) {
  return queries.map((query) => {
    const optics = new core.Optics();
    optics.setEye(query.eye);
    optics.setLens(query.lens);
    const list = query.targets.map(([azimuth, elevation, distance]) => optics.ellipse(azimuth, elevation, distance === 'inf' ? Infinity : distance));
    optics.delete();
    return list;
  });
}
if (typeof module !== 'undefined') module.exports = answers;

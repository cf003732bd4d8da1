// Asks the WebAssembly core and prints JSON: node core_bits.cjs CORE.js fields | sights | edges | ellipses FILE | answers < QUERIES.json
const crypto = require('crypto');
const fs = require('fs');
const answers = require('./core_answers.js');

const straight = {decentration_m: [0, 0], pantoscopic_tilt_rad: 0, wrap_rad: 0};

function prescription(sphere_D, cylinder_D, axis_deg) {
  return {sphere_D, cylinder_D, axis_deg, vertex_distance_m: 12e-3, prism_cm_per_m: 0, prism_base_deg: 0};
}

function eye(rx, pupil_diameter_m, accommodation) {
  return {prescription: rx, wavefront: null, pupil_diameter_m, rotation_center_m: 13.5e-3, accommodation};
}

function singleVision(rx) {
  return {kind: 'single_vision', prescription: rx, base_curve_D: null, center_thickness_m: 2e-3, refractive_index: 1.5,
          vertex_distance_m: 12e-3, diameter_m: 70e-3, mounting: straight};
}

const hash = (array) => crypto.createHash('sha256').update(Buffer.from(array.buffer)).digest('hex');

// The eye and the lenses of native_reference.cpp.
const ametrope = eye(prescription(-2, -1.5, 30), 4e-3, {mode: 'fixed', power_D: 0.5});
const lenses = {
  naked: null,
  toric: singleVision(null),
  progressive: {...singleVision(null), kind: 'progressive', center_thickness_m: 2.2e-3, refractive_index: 1.6, diameter_m: 60e-3,
                addition_D: 2, corridor_start_m: 0, corridor_length_m: 18e-3, near_shift_m: -2.5e-3, zone_width_m: 10e-3, knot_spacing_m: 0.125e-3},
};

function fields(core) {
  const grid = {nx: 32, ny: 32, nz: 256, tan_half_width: 0.7, tan_half_height: 0.5, near_vergence_D: 4, far_vergence_D: 0};
  const optics = new core.Optics();
  optics.setEye(ametrope);
  const result = {};
  for (const [name, lens] of Object.entries(lenses)) {
    optics.setLens(lens);
    result[name] = {analytic: hash(optics.fieldAnalytic(grid).nodes), voxels: hash(optics.fieldVoxels(grid).voxels)};
  }
  optics.delete();
  return result;
}

// Places in cells of which some nodes are beyond the rim: `alone` traces one.
function atRim(all, size, alone) {
  const found = {places: 0, wrong: 0, directions: 0};
  for (let j = 0; j + 1 < size; ++j)
    for (let i = 0; i + 1 < size; ++i) {
      const [a, b, c, d] = [0, 1, size, size + 1].map((k) => all.subarray(40 * (j * size + i + k)));
      const within = [a, b, c, d].filter((node) => node[3] > 0).length;
      if (within === 0 || within === 4) continue;
      for (const [u, v] of [[0.2, 0.3], [0.7, 0.2], [0.4, 0.6], [0.8, 0.9]]) {
        const between = (k) => (1 - v) * ((1 - u) * a[k] + u * b[k]) + v * ((1 - u) * c[k] + u * d[k]), truth = alone(i + u, j + v);
        found.places += 1;
        if (between(3) > 0 !== truth[3] > 0) found.wrong += 1;
        else if (truth[3] > 0) found.directions = Math.max(found.directions, ...[4, 5, 6].map((k) => Math.abs(between(k) - truth[k])));
      }
    }
  return found;
}

// Of a grid of sights to beyond the rim: how many nodes say otherwise than one that is asked for alone whether they reach, and by how much the others
// differ: places [m], directions, and the last map, which has the powers [1/m]. The same of places in cells that the rim crosses, between nodes. And the
// time that a picture's grid takes, 50° high and 16 by 9, and the same in pieces of six by six, too few for any that is not traced: the shortest of 40,
// since what other programs take of the machine only makes times longer.
function sights(core) {
  const optics = new core.Optics(), step = 0.02, size = 141, first = -1.4;
  optics.setEye(ametrope);
  const result = {};
  const tilted = {...lenses.toric, mounting: {decentration_m: [4e-3, -3e-3], pantoscopic_tilt_rad: 0.2, wrap_rad: 0.15}};
  for (const [name, lens] of Object.entries({toric: lenses.toric, progressive: lenses.progressive, tilted})) {
    optics.setLens(lens);
    const ask = (x, y, n) => optics.sights({gaze: 'foveal', first_x: x, first_y: y, step_x: step, step_y: step, columns: n, rows: n});
    const all = ask(first, first, size), found = result[name] = {stopped: 0, wrong: 0, places: 0, directions: 0, powers: 0};
    for (let k = 0; k < size * size; ++k) {
      const node = all.subarray(40 * k, 40 * k + 40), alone = ask(first + step * (k % size), first + step * Math.floor(k / size), 1);
      found.stopped += alone[3] > 0 ? 0 : 1;
      found.wrong += alone[3] > 0 === node[3] > 0 ? 0 : 1;
      if (alone[3] <= 0) continue;
      const apart = (from, to) => Math.max(...node.subarray(from, to).map((x, c) => Math.abs(x - alone[from + c])));
      found.places = Math.max(found.places, apart(0, 3));
      found.directions = Math.max(found.directions, apart(4, 7));
      found.powers = Math.max(found.powers, apart(24, 32));
    }
    found.rim = atRim(all, size, (i, j) => ask(first + step * i, first + step * j, 1));
    const picture = {gaze: 'foveal', first_x: -0.85, first_y: -0.49, step_x: step, step_y: step, columns: 87, rows: 51};
    const inPieces = () => {
      for (let y = 0; y < picture.rows; y += 6)
        for (let x = 0; x < picture.columns; x += 6)
          optics.sights({...picture, first_x: picture.first_x + step * x, first_y: picture.first_y + step * y, columns: Math.min(6, picture.columns - x), rows: Math.min(6, picture.rows - y)});
    };
    const timed = (work) => {
      const start = performance.now();
      work();
      return performance.now() - start;
    };
    [found.ms, found.traced_ms] = [Infinity, Infinity];
    for (let round = 0; round < 40; ++round) {
      found.ms = Math.min(found.ms, timed(() => optics.sights(picture)));
      found.traced_ms = Math.min(found.traced_ms, timed(inPieces));
    }
  }
  optics.delete();
  return result;
}

// How far from where spectacles of the page end a grid lets them end, for an eye that turns [slope]: along 90 lines from straight ahead, the largest and the mean.
function edges(core) {
  const optics = new core.Optics(), step = 0.02, size = 171, first = -1.7, result = {};
  optics.setEye(eye(prescription(-2, 0, 180), 4e-3, {mode: 'relaxed'}));
  for (const [name, power_D] of [['minus 8', -8], ['plus 5', 5], ['plus 8', 8]]) {
    optics.setLens({...singleVision(prescription(power_D, 0, 180)), refractive_index: 1.6, diameter_m: 65e-3, center_thickness_m: power_D > 0 ? 6e-3 : 2e-3});
    const ask = (x, y, n) => optics.sights({gaze: 'foveal', first_x: x, first_y: y, step_x: step, step_y: step, columns: n, rows: n}), all = ask(first, first, size);
    const between = (x, y) => {
      const i = Math.floor((x - first) / step), j = Math.floor((y - first) / step), u = (x - first) / step - i, v = (y - first) / step - j;
      const [a, b, c, d] = [0, 1, size, size + 1].map((k) => all[40 * (j * size + i + k) + 3]);
      return (1 - v) * ((1 - u) * a + u * b) + v * ((1 - u) * c + u * d);
    };
    const off = Array.from({length: 90}, (_, k) => {
      const c = Math.cos((4 * k + 0.1) * Math.PI / 180), s = Math.sin((4 * k + 0.1) * Math.PI / 180);
      const end = (within) => {
        let [low, high] = [0.05, 1.65];
        while (high - low > 1e-6) [low, high] = within(0.5 * (low + high)) ? [0.5 * (low + high), high] : [low, 0.5 * (low + high)];
        return low;
      };
      return Math.abs(end((r) => between(r * c, r * s) > 0) - end((r) => ask(r * c, r * s, 1)[3] > 0));
    });
    result[name] = {largest: Math.max(...off), mean: off.reduce((sum, x) => sum + x) / off.length};
  }
  optics.delete();
  return result;
}

// Largest differences from what native_reference.cpp wrote.
function ellipses(core, file) {
  const bytes = fs.readFileSync(file);
  const numbers = new Float64Array(bytes.buffer, bytes.byteOffset, bytes.length / 8);
  const worst = {count: 0, maps: 0, askance: 0, semi_axes: 0, angles_deg: 0};
  const optics = new core.Optics();
  for (let at = 0; at < numbers.length; at += 17) {
    const [s, c, a, pupil, azimuth, elevation, distance, ls, lc, la, xx, xy, yx, yy, major, minor, angle] = numbers.subarray(at, at + 17);
    optics.setEye(eye(prescription(s, c, a), pupil, {mode: 'fixed', power_D: 0.25}));
    optics.setLens(la < 0 ? null : singleVision(prescription(ls, lc, la)));
    const answer = optics.ellipse(azimuth, elevation, distance);
    worst.count += 1;
    const map = [xx, xy, yx, yy], largest = Math.max(...map.map(Math.abs));
    const difference = Math.max(...map.map((x, k) => Math.abs(x - answer.angular_footprint[k]))) / largest;
    if (azimuth !== 0) {
      worst.askance = Math.max(worst.askance, difference);
      continue;
    }
    worst.maps += difference === 0 ? 0 : 1;
    for (const [mine, native] of [[answer.semi_axes_rad[0], major], [answer.semi_axes_rad[1], minor]])
      if (native > 0) worst.semi_axes = Math.max(worst.semi_axes, Math.abs(mine - native) / native);
    const turn = Math.abs((answer.orientation_deg === null ? 1000 : answer.orientation_deg) - angle);
    worst.angles_deg = Math.max(worst.angles_deg, Math.min(turn, Math.abs(180 - turn)));
  }
  optics.delete();
  return worst;
}

// The messages of calls that must not succeed, and what rays and passes look like.
function manners(core) {
  const message = (call) => {
    try {
      call();
      return null;
    } catch (error) {
      return error instanceof Error ? error.message : `not an Error: ${error}`;
    }
  };
  const optics = new core.Optics();
  const good = eye(prescription(-2, -1.5, 30), 4e-3, {mode: 'relaxed'});
  const messages = {
    sphere: message(() => optics.setEye(eye(prescription(-99, 0, 180), 4e-3, {mode: 'relaxed'}))),
    mode: message(() => optics.setEye({...good, accommodation: {mode: 'lazy'}})),
    missing: message(() => optics.setEye({...good, pupil_diameter_m: undefined})),
    lens: message(() => optics.setLens({...singleVision(prescription(-2, 0, 180)), refractive_index: 1})),
    notation: message(() => core.readNotation('-2.00 -1.50')),
  };
  optics.setEye(good);
  const result = {messages, passes: Array.from(core.pupilPasses(3, 0.25)), noted: core.readNotation('OD -2.00 -1.50 x 30 ADD +2.00, OS -1.75 DS'),
                  naked_sight: Array.from(optics.sights({gaze: 'foveal', first_x: 0.25, first_y: 0, step_x: 1, step_y: 1, columns: 1, rows: 1})),
                  clear: optics.clearVision(0, 0, 1e-3), rays: Array.from(optics.rayModel('power_matrix', 0, Infinity, new Float32Array([1e-3, 0, 0, 1e-3])).slopes)};
  optics.delete();
  return result;
}

require(process.argv[2])().then((core) => {
  const what = {fields, sights, edges, ellipses, manners, answers: () => answers(core, JSON.parse(fs.readFileSync(0, 'utf8')))}[process.argv[3]];
  process.stdout.write(JSON.stringify(what(core, process.argv[4])));
});

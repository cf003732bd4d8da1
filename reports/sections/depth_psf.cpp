#include "reports/sections/depth_psf.h"

#include <algorithm>

#include "compare/findings/picture_json.h"
#include "compare/studies/depth_psf/depth_psf_findings.h"
#include "io/files/error.h"
#include "io/files/formatted_text.h"
#include "io/images/tone_map.h"
#include "reports/markup/html_table.h"
#include "reports/markup/numbers.h"
#include "reports/markup/parts.h"
#include "reports/markup/pictures.h"
#include "reports/sections/command.h"

namespace sturm {

namespace {

/// Map cells are greyer the less rays and waves have in common.
std::string shade_of(const Number& variation) {
  return variation ? "background:rgba(178,24,43," + plain_number(std::min(1.0, 1.5 * *variation), 2) + ")" : "";
}

template <class Value>
void add_once(std::vector<Value>& list, const Value& value) {
  if (std::find(list.begin(), list.end(), value) == list.end()) list.push_back(value);
}

Html radii_html(const SpreadCell& cell) {
  if (!cell.rays_r50_arcmin || !cell.waves_r50_arcmin || !(*cell.waves_r50_arcmin > 0.0)) return {};
  return small_html(number_html(100.0 * (*cell.rays_r50_arcmin / *cell.waves_r50_arcmin - 1.0), 2) + " %"_html);
}

/// Pupils down, vergence errors across.
Html map_table(const std::vector<SpreadCell>& map, const std::string& light, const std::string& caption) {
  std::vector<Number> pupils, errors;
  for (const SpreadCell& cell : map)
    if (cell.light == light) {
      add_once(pupils, cell.pupil_mm);
      add_once(errors, cell.defocus_D);
    }
  if (pupils.empty()) return {};
  std::vector<Column> columns = {{"Pupil"_html, false}};
  for (const Number& error : errors) columns.push_back({exact_html(error) + " D"_html});
  HtmlTable table(caption, "", columns);
  for (const Number& pupil : pupils) {
    std::vector<Cell> row = {exact_html(pupil) + " mm"_html};
    for (const SpreadCell& cell : map)
      if (cell.light == light && cell.pupil_mm == pupil)
        row.push_back(
            inline_element("span", {{"style", shade_of(cell.total_variation)}}, number_html(cell.total_variation, 2)) +
            radii_html(cell));
    row.resize(columns.size(), Cell(absent_html()));
    table.add_row(row);
  }
  return table.html();
}

Html quartiles_html(const Quartiles& quartiles) {
  return number_html(quartiles[1], 3) +
         small_html(number_html(quartiles[0], 3) + " … "_html + number_html(quartiles[2], 3));
}

Html eyes_table(const std::vector<EyesBeyond>& eyes) {
  HtmlTable table("What measured eyes have beyond second order: medians, with quartiles", "",
                  {{"Eyes"_html, false},
                   {"Number"_html},
                   {"Pupil [mm]"_html},
                   {"Root mean square [µm]"_html},
                   {"Defocus with that root mean square [D]"_html},
                   {"80 % of the rays within, second order corrected [arcmin]"_html},
                   {"Share above 0.25 D"_html}});
  for (const EyesBeyond& entry : eyes)
    table.add_row({text_or_dash(entry.title), count_html(Number(entry.eyes)), exact_html(entry.pupil_mm),
                   quartiles_html(entry.rms_um), quartiles_html(entry.defocus_D), quartiles_html(entry.r80_arcmin),
                   number_html(entry.share_above_step, 2)});
  return table.html();
}

Html banding_table(const std::vector<BandingRow>& rows) {
  HtmlTable table("A striped surface that leans from far to near, by the spacing of its planes", "",
                  {{"Spacing [px]"_html},
                   {"Planes"_html},
                   {"Light of a pixel"_html, false},
                   {"Parts of the pupil"_html},
                   {"RMSE"_html},
                   {"Largest false step [1/255]"_html}});
  for (const BandingRow& row : rows)
    table.add_row({exact_html(row.spacing_px), count_html(Number(row.planes)),
                   row.weights == "nearest" ? "to the nearest plane"_html : "linear between two planes"_html,
                   count_html(Number(row.pupil_parts)), number_html(row.rmse, 2),
                   number_html(row.largest_step ? Number(255.0 * *row.largest_step) : std::nullopt, 2)});
  return table.html();
}

Html still(const std::filesystem::path& run_folder, const PictureFiles& files, const std::string& title) {
  try {
    return picture_html(to_display(main_layer(run_folder / files.exr), 1.0), title);
  } catch (const InputError& error) {
    return missing_html(text(title + ": " + error.what()));
  }
}

std::string with_error(const std::string& title, const PredictionFinding& prediction) {
  const PartErrors whole = prediction.whole();
  std::string text = title;
  if (whole.ssim && whole.ssim->value) text += ", SSIM " + plain_number(*whole.ssim->value, 4);
  for (const PartErrors& part : prediction.parts)
    if (part.name == "occlusion_edges" && part.ssim && part.ssim->value)
      text += ", at edges " + plain_number(*part.ssim->value, 4);
  if (whole.rmse.value) text += ", RMSE " + plain_number(*whole.rmse.value, 3);
  return text;
}

/// Of each view that has both: the sum of its layers, the layers composited, the truth.
Html compositions(const Json& report, const std::filesystem::path& run_folder) {
  Html html;
  for (const PictureFinding& view : picture_findings(report)) {
    const PredictionFinding *sum = nullptr, *composited = nullptr;
    for (const PredictionFinding& prediction : view.predictions) {
      if (prediction.kind_name() == "depth_psf_sum") sum = &prediction;
      if (prediction.kind_name() == "depth_psf") composited = &prediction;
    }
    if (!sum || !composited) continue;
    html +=
        element("h3", text_or_dash(view.id) + (view.note.empty() ? Html() : " "_html + small_html(text(view.note)))) +
        element("div", {{"class", "three stills"}},
                still(run_folder, sum->files, with_error("Layers blurred and added", *sum)) +
                    still(run_folder, composited->files, with_error("Layers composited", *composited)) +
                    still(run_folder, view.path_traced, "Path traced"));
  }
  if (html.empty()) return html;
  return element("p",
                 "The same surfaces, blurred by the same point spreads. Where blurred layers are only added, the light "
                 "of what lies behind shines into what hides it, and edges have dark rims where a near layer's light "
                 "is spread and nothing is known behind it. SSIM and RMSE are in display space."_html) +
         html;
}

}  // namespace

Html depth_psf_section(const Json& report, const std::filesystem::path& run_folder) {
  Html html = compositions(report, run_folder);
  if (const std::optional<DepthPsfFindings> found = depth_psf_findings(report)) {
    if (!found->map.empty())
      html += element("p",
                      "Total variation between the point spreads by rays and by waves of an eye without aberration: 0 "
                      "where they are the same, 1 where they share no light. Small: by how much the radius of half of "
                      "the light differs, rays against waves. In white light both have the eye's chromatic "
                      "defocus."_html) +
              map_table(found->map, "one_wavelength", "Rays against waves, one wavelength") +
              map_table(found->map, "white", "Rays against waves, white light");
    if (!found->eyes.empty()) html += eyes_table(found->eyes);
    if (!found->banding.empty()) html += banding_table(found->banding);
  }
  if (html.empty()) return {};
  return element("section", {{"id", "depth_psf_study"}},
                 element("h2", "Point spreads over depth"_html) + html + made_by(report));
}

}  // namespace sturm

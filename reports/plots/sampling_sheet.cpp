#include "reports/plots/sampling_sheet.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "compare/studies/stored_words.h"
#include "io/files/formatted_text.h"
#include "io/files/text_file.h"
#include "reports/markup/html.h"
#include "reports/markup/pictures.h"

namespace sturm {

namespace {

constexpr double label_width = 190.0, heading_height = 34.0, caption_height = 22.0, sheet_gap = 8.0;  // [px]
constexpr double picture_width = 240.0;

/// The values of one member in the order in which they appear, as words.
template <class Word>
std::vector<std::string> different(const std::vector<SamplingEntry>& entries, const Word& word) {
  std::vector<std::string> values;
  for (const SamplingEntry& entry : entries)
    if (const std::string value = word(entry); std::find(values.begin(), values.end(), value) == values.end())
      values.push_back(value);
  return values;
}

std::string sampling_of(const SamplingEntry& entry) {
  return word_of(entry.sampling);
}

std::string sampler_of(const SamplingEntry& entry) {
  return word_of(entry.sampler);
}

std::string configuration_of(const SamplingEntry& entry) {
  return entry.configuration;
}

/// Plain text at (x, y), drawn with `style`.
Html words_at(double x, double y, const Attributes& style, const std::string& words) {
  Attributes attributes = {{"x", plain_number(x)}, {"y", plain_number(y)}};
  attributes.insert(attributes.end(), style.begin(), style.end());
  return element("text", attributes, text(words));
}

std::string percent(double part, double whole) {
  return plain_number(100.0 * part / whole, 2) + " %";
}

/// Bias, where it can be told from none at 4 σ, and noise, relative to the mean radiance.
std::string numbers_of(const SamplingEntry& entry) {
  const Number &square = entry.mean_square_bias, &z = entry.z, &noise = entry.noise, &brightness = entry.mean_radiance;
  if (!square || !z || !noise || !brightness || !(*brightness > 0.0)) return "no numbers";
  constexpr double told_apart = 4.0;
  const std::string bias = *z > told_apart ? percent(std::sqrt(*square), *brightness) : "none seen";
  return "bias " + bias + " · noise " + percent(*noise, *brightness);
}

class Sheet {
 public:
  Sheet(const std::vector<SamplingEntry>& entries, std::string sampler, const std::filesystem::path& run_folder)
      : entries_(entries),
        sampler_(std::move(sampler)),
        run_folder_(run_folder),
        columns_(different(entries, sampling_of)),
        rows_(different(entries, configuration_of)) {}

  std::string svg() const {
    Html body =
        "\n"_html + empty_element("rect", {{"width", "100%"}, {"height", "100%"}, {"fill", "#fff"}}) + "\n"_html;
    double width = 0.0, y = heading_height;
    for (std::size_t c = 0; c < columns_.size(); ++c)
      body += words_at(left(c) + picture_width / 2, heading_height - 12,
                       {{"text-anchor", "middle"}, {"font-weight", "bold"}}, columns_[c]);
    for (const std::string& row : rows_) {
      double height = 0.0;
      for (std::size_t c = 0; c < columns_.size(); ++c)
        if (const SamplingEntry* entry = find(row, columns_[c])) body += cell(*entry, left(c), y, height);
      body += label(row, y, height);
      width = std::max(width, left(columns_.size()));
      y += height + caption_height + sheet_gap;
    }
    return element("svg",
                   {{"xmlns", "http://www.w3.org/2000/svg"},
                    {"viewBox", "0 0 " + plain_number(width) + " " + plain_number(y)},
                    {"width", plain_number(width)},
                    {"height", plain_number(y)},
                    {"font-family", "sans-serif"},
                    {"font-size", "13"},
                    {"fill", "#222"}},
                   body)
        .markup();
  }

 private:
  static double left(std::size_t column) {
    return label_width + static_cast<double>(column) * (picture_width + sheet_gap);
  }

  const SamplingEntry* find(const std::string& configuration, const std::string& sampling) const {
    for (const SamplingEntry& entry : entries_)
      if (entry.configuration == configuration && sampling_of(entry) == sampling && sampler_of(entry) == sampler_)
        return &entry;
    return nullptr;
  }

  /// Picture and caption; `height` becomes the picture's.
  Html cell(const SamplingEntry& entry, double x, double y, double& height) const {
    const auto png = file_contents(run_folder_ / entry.files.picture_png);
    const double ratio = entry.aspect_ratio.value_or(1.5);
    height = picture_width / ratio;
    Attributes attributes = {{"x", plain_number(x)},
                             {"y", plain_number(y)},
                             {"width", plain_number(picture_width)},
                             {"height", plain_number(height)}};
    if (png)
      attributes.push_back({"href", "data:image/png;base64," + base64({png->begin(), png->end()})});
    else
      attributes.insert(attributes.end(), {{"fill", "none"}, {"stroke", "#999"}});
    return empty_element(png ? "image" : "rect", attributes) + "\n"_html +
           words_at(x + picture_width / 2, y + height + 16, {{"text-anchor", "middle"}, {"font-size", "12"}},
                    numbers_of(entry));
  }

  /// Name, ray model and note of a row, the note broken into lines.
  Html label(const std::string& row, double y, double height) const {
    const SamplingEntry* entry = nullptr;
    for (const std::string& column : columns_)
      if (!entry) entry = find(row, column);
    if (!entry) return {};
    std::string name = row;
    std::replace(name.begin(), name.end(), '_', ' ');
    double at = y + 0.3 * height;
    Html html = words_at(8, at, {{"font-weight", "bold"}}, name);
    html += words_at(8, at += 18, {{"font-family", "monospace"}, {"font-size", "12"}}, word_of(entry->ray_model));
    constexpr std::size_t longest_line = 24;
    std::string line;
    const std::string note = entry->note + " ";
    for (std::size_t begin = 0; begin < note.size();) {
      const std::size_t end = note.find(' ', begin);
      const std::string word = note.substr(begin, end - begin);
      if (!line.empty() && line.size() + 1 + word.size() > longest_line) {
        html += words_at(8, at += 16, {{"font-size", "12"}}, line);
        line.clear();
      }
      line += (line.empty() ? "" : " ") + word;
      begin = end + 1;
    }
    return html + (line.empty() ? Html() : words_at(8, at + 16, {{"font-size", "12"}}, line));
  }

  const std::vector<SamplingEntry>& entries_;
  std::string sampler_;
  const std::filesystem::path& run_folder_;
  std::vector<std::string> columns_, rows_;
};

}  // namespace

std::vector<Figure> sampling_sheets(const SamplingFindings& found, const std::filesystem::path& run_folder) {
  std::vector<Figure> figures;
  for (const std::string& sampler : different(found.entries, sampler_of))
    figures.push_back({"sampling_study_" + sampler, "sampling_study",
                       "Configurations and pupil samplings, " + sampler + " numbers",
                       "Each picture is the mean of all replicates. Bias: RMS difference of the means to the uniform "
                       "disc; noise: RMS "
                       "deviation of one replicate; both relative to the mean radiance.",
                       "", Sheet(found.entries, sampler, run_folder).svg()});
  return figures;
}

}  // namespace sturm

// Based on: Illuminating Engineering Society, "ANSI/IES LM-63-19: IES Standard File Format for the Electronic Transfer of
// Photometric Data", 2019, and its predecessors of 1986, 1991, 1995 and 2002. They differ in the part before the TILT line.
// 1. The lines up to TILT= are keywords.
// 2. The numbers after TILT= may have line breaks anywhere: the lamp, the numbers of angles, the type of photometry, the
//    luminaire's size, the ballast, the vertical angles, the horizontal angles, and the candelas. The candelas of all vertical
//    angles at the first horizontal angle come first.
// 3. Angles that cover a half or a quarter of the full range are completed by symmetry.
//
// We deviate:
// 1. Commas between numbers count as blanks because several programs write them.
// 2. Horizontal angles of type C may end between 180 and 360 degrees. They are then completed to a full circle.
#include "scene/ies.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "core/file_content.hpp"
#include "scene/lexer.hpp"
#include "scene/photometric_web.hpp"

namespace lippmann {
namespace {

constexpr float kMostCandelas = 1e12f;
constexpr int kMostAngles = 100000;
constexpr float kLeastStep = 1e-3f;

enum class Photometry { kC = 1, kB = 2, kA = 3 };

struct MeasuredWeb {
  Photometry type = Photometry::kC;
  std::vector<float> vertical, horizontal;
  std::vector<std::vector<float>> candelas;
};

/// Returns whether a keyword is known and does not affect the light. Examples are names of makers, dates, and the user's own
/// keywords [_NAME].
bool is_known_keyword(std::string_view keyword) {
  constexpr std::string_view kKnown[] = {"TEST",      "TESTLAB",       "TESTMETHOD",   "TESTDATE",  "ISSUEDATE",
                                         "DATE",      "MANUFAC",       "LUMCAT",       "LUMINAIRE", "LAMPCAT",
                                         "LAMP",      "BALLAST",       "BALLASTCAT",   "MAINTCAT",  "DISTRIBUTION",
                                         "FLASHAREA", "COLORCONSTANT", "LAMPPOSITION", "NEARFIELD", "FILEGENINFO",
                                         "SEARCH",    "OTHER",         "MORE",         "BLOCK",     "ENDBLOCK"};
  return keyword.starts_with('_') || std::find(std::begin(kKnown), std::end(kKnown), keyword) != std::end(kKnown);
}

void note_keyword(std::string_view line, const std::string& where, LeftOut& left_out) {
  const std::size_t begin = line.find_first_not_of(" \t"), end = line.find(']');
  if (begin == line.npos || line[begin] != '[' || end == line.npos) return;
  if (!is_known_keyword(line.substr(begin + 1, end - begin - 1))) left_out.add(line.substr(begin, end + 1 - begin), where);
}

/// Removes the lines up to the TILT= line from `text`, but keeps their line breaks so that line numbers stay valid. Returns the
/// value of TILT.
std::string take_header(const std::string& name, std::string& text, LeftOut& left_out) {
  int line_number = 1;
  for (std::size_t begin = 0; begin < text.size(); ++line_number) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string line = upper(std::string_view(text).substr(begin, end - begin));
    if (const std::size_t at = line.find_first_not_of(" \t"); at != line.npos && line.compare(at, 4, "TILT") == 0) {
      const auto lines =
          static_cast<std::size_t>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(end), '\n'));
      text.replace(0, end, std::string(lines, '\n'));
      std::replace(text.begin(), text.end(), ',', ' ');
      return line.substr(at + 4);
    }
    note_keyword(line, fmt::format("{}:{}", name, line_number), left_out);
    begin = end + 1;
  }
  const FileContent content = describe_content(std::as_bytes(std::span(text)));
  if (!content.advice.empty()) throw Error(name, "is " + content.what, content.advice);
  throw Error(name, fmt::format("is {} without a TILT line", content.what), "an IES LM-63 photometric file");
}

class IesReader {
 public:
  explicit IesReader(Lexer& lexer) : lexer_(lexer) {}

  MeasuredWeb read(bool has_tilt) {
    if (has_tilt) skip_tilt();
    skip_numbers({"the number of lamps", "lumens per lamp"});
    const float multiplier = factor("the multiplier of candelas");
    const int vertical = lexer_.integer("the number of vertical angles", 2, kMostAngles);
    const int horizontal = lexer_.integer("the number of horizontal angles", 1, kMostAngles);
    web_.type = static_cast<Photometry>(lexer_.integer("the type of photometry", 1, 3));
    skip_numbers({"the unit of lengths", "the width", "the length", "the height"});
    const float ballast = factor("the ballast factor"), photometric = factor("the ballast-lamp photometric factor");
    skip_numbers({"the input watts"});
    web_.vertical = angles("a vertical angle", vertical);
    web_.horizontal = angles("a horizontal angle", horizontal);
    read_candelas(static_cast<double>(multiplier) * static_cast<double>(ballast) * static_cast<double>(photometric));
    return std::move(web_);
  }

 private:
  void skip_numbers(std::initializer_list<std::string_view> wanted) {
    for (const std::string_view number : wanted) lexer_.number(number);
  }

  void skip_tilt() {
    lexer_.number("the lamp-to-luminaire geometry");
    const int count = lexer_.integer("the number of tilt angles", 0, kMostAngles);
    for (int i = 0; i < 2 * count; ++i) lexer_.number("an angle or a factor of the tilt");
  }

  float not_negative(std::string_view wanted, float largest) {
    const float value = lexer_.number(wanted, largest);
    if (value < 0.0f) throw lexer_.error(fmt::format("{} is {}", wanted, value), "a number >= 0");
    return value;
  }

  float factor(std::string_view wanted) { return not_negative(wanted, 1e6f); }

  std::vector<float> angles(std::string_view wanted, int count) {
    std::vector<float> angles;
    for (int i = 0; i < count; ++i) {
      angles.push_back(lexer_.number(wanted, 360.0f));
      if (i > 0 && !(angles.back() - angles[angles.size() - 2] >= kLeastStep))
        throw lexer_.error(fmt::format("{} is {} after {}", wanted, angles.back(), angles[angles.size() - 2]),
                           fmt::format("angles that increase by at least {} degrees", kLeastStep));
    }
    return angles;
  }

  void read_candelas(double scale) {
    for (std::size_t h = 0; h < web_.horizontal.size(); ++h) {
      std::vector<float>& row = web_.candelas.emplace_back();
      for (std::size_t v = 0; v < web_.vertical.size(); ++v) {
        const double candelas = scale * static_cast<double>(not_negative("a candela value", kMostCandelas));
        if (candelas > static_cast<double>(kMostCandelas))
          throw lexer_.error(fmt::format("is {} candelas", candelas), fmt::format("at most {}", kMostCandelas));
        row.push_back(static_cast<float>(candelas));
      }
    }
  }

  Lexer& lexer_;
  MeasuredWeb web_;
};

void mirror_back(std::vector<float>& angles) {
  const float last = angles.back();
  for (std::size_t i = angles.size() - 1; i-- > 0;) angles.push_back(2.0f * last - angles[i]);
}

void mirror_front(std::vector<float>& angles) {
  const float first = angles.front();
  std::vector<float> before;
  for (std::size_t i = angles.size(); i-- > 1;) before.push_back(2.0f * first - angles[i]);
  angles.insert(angles.begin(), before.begin(), before.end());
}

template <class T>
void repeat_back(std::vector<T>& of_angle) {
  for (std::size_t i = of_angle.size() - 1; i-- > 0;) of_angle.push_back(T(of_angle[i]));
}

template <class T>
void repeat_front(std::vector<T>& of_angle) {
  const std::vector<T> before(of_angle.rbegin(), of_angle.rend() - 1);
  of_angle.insert(of_angle.begin(), before.begin(), before.end());
}

bool go_from(const std::vector<float>& angles, float from, float to) { return angles.front() == from && angles.back() == to; }

[[noreturn]] void throw_range_error(const Lexer& lexer, const char* what, const std::vector<float>& angles,
                                    const char* accepted) {
  throw Error(lexer.name(), fmt::format("the {} angles go from {} to {} degrees", what, angles.front(), angles.back()),
              accepted);
}

void complete_circle(const Lexer& lexer, MeasuredWeb& web) {
  std::vector<float>& angles = web.horizontal;
  if (angles.size() == 1) return;
  if (go_from(angles, 0.0f, 90.0f)) mirror_back(angles), repeat_back(web.candelas);
  if (go_from(angles, 0.0f, 180.0f)) mirror_back(angles), repeat_back(web.candelas);
  if (go_from(angles, 90.0f, 270.0f)) mirror_front(angles), repeat_front(web.candelas);
  if (angles.front() == 0.0f && angles.back() > 180.0f && angles.back() < 360.0f)
    angles.push_back(360.0f), web.candelas.push_back(std::vector<float>(web.candelas.front()));
  if (angles.back() - angles.front() != 360.0f || angles.front() < -180.0f)
    throw_range_error(lexer, "horizontal", angles, "0 to 90, 0 to 180, 0 to 360, or 90 to 270 degrees");
}

void complete_sides(const Lexer& lexer, MeasuredWeb& web) {
  const auto require_full_range = [&](const char* what, const std::vector<float>& angles) {
    if (!go_from(angles, -90.0f, 90.0f)) throw_range_error(lexer, what, angles, "0 to 90, or -90 to 90 degrees");
  };
  if (go_from(web.horizontal, 0.0f, 90.0f)) mirror_front(web.horizontal), repeat_front(web.candelas);
  if (go_from(web.vertical, 0.0f, 90.0f)) {
    mirror_front(web.vertical);
    for (std::vector<float>& row : web.candelas) repeat_front(row);
  }
  require_full_range("horizontal", web.horizontal);
  require_full_range("vertical", web.vertical);
}

std::vector<float> in_radians(const std::vector<float>& degrees, float offset) {
  std::vector<float> angles;
  for (const float d : degrees) angles.push_back(std::min(radians(d + offset), d + offset <= 180.0f ? kPi : 2.0f * kPi));
  return angles;
}

PhotometricWeb web_of_type_c(const MeasuredWeb& measured) {
  PhotometricWeb web;
  web.polar = in_radians(measured.vertical, 0.0f), web.azimuth = in_radians(measured.horizontal, 0.0f);
  for (const std::vector<float>& row : measured.candelas) web.intensity.insert(web.intensity.end(), row.begin(), row.end());
  web.web_from_light = Mat3f({1, 0, 0}, {0, 1, 0}, {0, 0, -1});
  return web;
}

/// The polar axis of type A points down, along the light's -y. Horizontal angles are azimuths around it.
PhotometricWeb web_of_type_a(const MeasuredWeb& measured) {
  PhotometricWeb web;
  web.polar = in_radians(measured.vertical, 90.0f), web.azimuth = in_radians(measured.horizontal, 0.0f);
  for (const std::vector<float>& row : measured.candelas) web.intensity.insert(web.intensity.end(), row.begin(), row.end());
  web.web_from_light = glm::transpose(Mat3f({0, 0, -1}, {1, 0, 0}, {0, -1, 0}));
  return web;
}

/// The polar axis of type B points to the left, along the light's -x. Vertical angles are azimuths around it.
PhotometricWeb web_of_type_b(const MeasuredWeb& measured) {
  PhotometricWeb web;
  web.polar = in_radians(measured.horizontal, 90.0f), web.azimuth = in_radians(measured.vertical, 0.0f);
  for (std::size_t v = 0; v < measured.vertical.size(); ++v)
    for (const std::vector<float>& row : measured.candelas) web.intensity.push_back(row[v]);
  web.web_from_light = glm::transpose(Mat3f({0, 0, -1}, {0, 1, 0}, {-1, 0, 0}));
  return web;
}

PhotometricWeb web_of(const Lexer& lexer, MeasuredWeb& measured) {
  if (measured.type == Photometry::kC) {
    if (measured.vertical.front() < 0.0f || measured.vertical.back() > 180.0f)
      throw_range_error(lexer, "vertical", measured.vertical, "0 to 90, 90 to 180, or 0 to 180 degrees");
    complete_circle(lexer, measured);
    return web_of_type_c(measured);
  }
  complete_sides(lexer, measured);
  return measured.type == Photometry::kA ? web_of_type_a(measured) : web_of_type_b(measured);
}

}  // namespace

IesProfile parse_ies(const std::string& name, std::string text) {
  LeftOut left_out;
  const std::string tilt = take_header(name, text, left_out);
  if (tilt.find("NONE") == tilt.npos) left_out.add("TILT", name);
  Lexer lexer(name, std::move(text));
  MeasuredWeb measured = IesReader(lexer).read(tilt.find("INCLUDE") != tilt.npos);
  if (!lexer.at_end()) {
    const std::string_view more = lexer.word("an end");
    left_out.add(more, lexer.where());
  }
  IesProfile profile{.web = web_of(lexer, measured), .left_out = std::move(left_out)};
  profile.web.name = name;
  const double mean = mean_intensity(profile.web);
  profile.mean_candela = static_cast<float>(mean);
  if (!(profile.mean_candela > 0.0f))
    std::fill(profile.web.intensity.begin(), profile.web.intensity.end(), 0.0f);
  else
    for (float& i : profile.web.intensity) i = static_cast<float>(static_cast<double>(i) / mean);
  return profile;
}

}  // namespace lippmann

// A page to look at a study: the mean shape with maps of its points, modes with sliders, outliers, and the figures of
// each subject; one HTML file that loads nothing.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "mesh/mesh.h"

namespace orbicube::cli {

// How a map of the points is colored: from 0; vectors by their part along the normals; significance below 0.05.
enum class MapKind { size, vectors, probability };

struct StudyPageMap {
  std::string name, title;
  MapKind kind;
  std::vector<double> values;  // one a point, of vectors three
};

// What the mean can be moved by, with a slider.
struct StudyPageShift {
  std::string id, name, unit;
  double limit;                 // of the slider, at both sides
  std::vector<double> vectors;  // three a point
};

struct StudyPageSubject {
  std::string name;
  std::vector<std::variant<double, std::string>> values;  // one a column; a value that is not finite is none
  double distance;                                        // from the mean
  bool outlier;
  int group;                   // 0 or 1
  std::vector<double> scores;  // amounts of the shifts, as far as they are modes
};

struct StudyPageFailure {
  std::string name, text;
};

struct StudyPage {
  std::string title, summary;
  std::span<const mesh::Vector3> mean;
  std::span<const mesh::Triangle> triangles;
  std::vector<StudyPageMap> maps;
  std::string first_map;  // the name of the map shown first
  std::vector<StudyPageShift> shifts;
  std::vector<double> fractions;     // of the variance, by mode
  std::vector<std::string> columns;  // of the table, besides the name
  std::vector<std::string> groups;   // names of the two, or none
  std::vector<StudyPageSubject> subjects;
  std::vector<StudyPageFailure> failed;
};

// Returns the text of the page, complete: 8 bytes a point and shift, 3 a point and map, 32 a point besides. Names are
// escaped. Positions and values are in 65,536 steps of their range.
std::string study_page(const StudyPage& study);

}  // namespace orbicube::cli

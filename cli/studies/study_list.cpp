#include "studies/study_list.h"

#include <algorithm>
#include <set>
#include <string_view>
#include <utility>

#include "base/error.h"
#include "base/files/file.h"
#include "files/surface_file.h"
#include "images/label_file.h"
#include "session/failure.h"
#include "studies/subject_file.h"

namespace orbicube::cli {
namespace {

using Row = std::vector<std::string>;

constexpr std::string_view blanks = " \t";

std::string without_blanks(const std::string& text) {
  const std::size_t first = text.find_first_not_of(blanks);
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

// Rows of cells (RFC 4180); blank lines are left out. Line numbers go to `lines`.
std::vector<Row> csv_rows(std::string_view text, std::vector<std::size_t>& lines) {
  std::vector<Row> rows;
  Row row;
  std::string cell;
  bool quoted = false, was_quoted = false;
  std::size_t line = 1, start = 1;
  const auto end_cell = [&] {
    row.push_back(was_quoted ? cell : without_blanks(cell));
    cell.clear();
    was_quoted = false;
  };
  const auto end_row = [&] {
    end_cell();
    if (row.size() > 1 || !row[0].empty()) {
      rows.push_back(row);
      lines.push_back(start);
    }
    row.clear();
    start = line + 1;
  };
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (quoted && c == '"' && i + 1 < text.size() && text[i + 1] == '"') {
      cell += text[++i];
    } else if (c == '"' && (quoted || without_blanks(cell).empty())) {
      quoted = !quoted;
      if (quoted) cell.clear();
      was_quoted = true;
    } else if (c == ',' && !quoted) {
      end_cell();
    } else if (c == '\n' && !quoted) {
      end_row();
    } else if (c != '\r' || quoted) {
      cell += c;
    }
    if (c == '\n') ++line;
  }
  if (quoted) throw base::Error("parse", "line " + std::to_string(start) + ": a quote is not closed");
  end_row();
  return rows;
}

std::vector<StudySubject> subjects_of_table(const std::filesystem::path& path, const base::Host& host) {
  const base::Array<std::byte> bytes = base::read_file(path, host);
  std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
  if (text.find('\0') != std::string_view::npos)
    throw base::Error("parse", "no table of a study: it has a byte 0; give a folder, or CSV with a column 'file'");
  std::vector<std::size_t> lines;
  const std::vector<Row> rows = csv_rows(text, lines);
  if (rows.empty()) throw base::Error("empty-file", "the table has no line");
  const Row& head = rows[0];
  const auto file_column = std::find(head.begin(), head.end(), "file");
  if (file_column == head.end())
    throw base::Error("parse", "line " + std::to_string(lines[0]) + ": no column is called 'file'");
  for (auto name = head.begin(); name != head.end(); ++name) {
    if (!name->empty() && std::find(name + 1, head.end(), *name) != head.end())
      throw base::Error("parse", "line " + std::to_string(lines[0]) + ": two columns are called '" + *name + "'");
  }
  std::vector<StudySubject> subjects;
  for (std::size_t r = 1; r < rows.size(); ++r) {
    if (rows[r].size() != head.size()) {
      throw base::Error("parse", "line " + std::to_string(lines[r]) + ": " + std::to_string(rows[r].size()) +
                                     " cells, where the first line has " + std::to_string(head.size()));
    }
    StudySubject subject;
    for (std::size_t c = 0; c < head.size(); ++c) {
      if (head[c] == "file")
        subject.file = path.parent_path() / rows[r][c];
      else
        subject.values[head[c]] = rows[r][c];
    }
    if (!subject.file.has_filename())
      throw base::Error("parse", "line " + std::to_string(lines[r]) + ": there is no name of a file");
    subjects.push_back(std::move(subject));
  }
  return subjects;
}

std::vector<StudySubject> subjects_of_folder(const std::filesystem::path& path) {
  std::vector<StudySubject> subjects;
  std::error_code problem;
  for (std::filesystem::directory_iterator entry(path, problem), end; !problem && entry != end;
       entry.increment(problem)) {
    const std::filesystem::path& file = entry->path();
    std::error_code unknown;
    if (!is_gltf(file) && !is_label_image(file) && !mesh::format_of_path(file)) continue;
    if (!std::filesystem::is_directory(file, unknown)) subjects.push_back({"", file, {}});
  }
  if (problem) throw base::Error("io", "cannot read the folder: " + problem.message());
  std::sort(subjects.begin(), subjects.end(),
            [](const StudySubject& a, const StudySubject& b) { return a.file.native() < b.file.native(); });
  return subjects;
}

// File systems that take upper and lower case for the same give no subject the files of another.
std::string folded(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

void name_subjects(std::vector<StudySubject>& subjects) {
  std::set<std::string> taken;
  for (StudySubject& subject : subjects) {
    const std::string stem = name_of_subject(subject.file);
    subject.name = stem;
    for (std::size_t number = 2; !taken.insert(folded(subject.name)).second; ++number)
      subject.name = stem + "-" + std::to_string(number);
  }
}

}  // namespace

std::vector<StudySubject> read_study_list(const std::filesystem::path& path, const base::Host& host) {
  return about(path, Role::input, [&] {
    std::error_code problem;
    std::vector<StudySubject> subjects =
        std::filesystem::is_directory(path, problem) ? subjects_of_folder(path) : subjects_of_table(path, host);
    if (subjects.size() < 2) {
      throw base::Error("invalid-argument", "a study needs two surfaces or more; there are " +
                                                std::to_string(subjects.size()) + " with one of " + surface_endings +
                                                " " + label_image_endings);
    }
    name_subjects(subjects);
    return subjects;
  });
}

std::string csv_cell(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos && text == without_blanks(text)) return text;
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"') result += '"';
    result += c;
  }
  return result + "\"";
}

}  // namespace orbicube::cli

// What a file holds besides its shape, which is not kept: counted by name, for one note.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "base/counted.h"

namespace orbicube::mesh {

struct LeftOut {
  std::size_t count;
  const char* one;
  const char* many;
};

// Adds "left out: 3 colors, 1 material" to the notes, without those of which there is none; nothing if there are none.
inline void note_left_out(const std::vector<LeftOut>& things, std::vector<std::string>& notes) {
  std::string text;
  for (const auto& [count, one, many] : things) {
    if (count == 0) continue;
    text.append(text.empty() ? "left out: " : ", ").append(base::counted(count, one, many));
  }
  if (!text.empty()) notes.push_back(text);
}

}  // namespace orbicube::mesh

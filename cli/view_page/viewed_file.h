// What `orbicube view` shows of a file.
#pragma once

#include <deque>
#include <filesystem>
#include <string>

#include "scenes/view_page.h"
#include "session/session.h"

namespace orbicube::cli {

struct ViewedFile {
  mesh::Mesh mesh;
  std::deque<mesh::Mesh> targets;  // maps of the surface
  ViewItem item;                   // a view of these
};

// Reads a mesh of any format; of glTF also the morph targets. Throws Failure.
void read_viewed(const std::filesystem::path& path, bool weld, Session& session, ViewedFile& file);

// Adds the singular curves of the frame field in a file, of the tetrahedra that are there. Throws Failure.
void add_field(const std::filesystem::path& path, Session& session, ViewedFile& file);

bool is_frames(const std::filesystem::path& path);

}  // namespace orbicube::cli

#include "images/label_surface.h"

#include <string>
#include <string_view>

#include "base/error.h"

namespace orbicube::cli {

repair::LabelSurface extract_label(const LabelFile& file, const repair::LabelOptions& options, const base::Host& host) {
  try {
    return repair::surface_of_label(file.image(), options, host);
  } catch (const base::Error& error) {
    if (std::string_view(error.what()).rfind("no label is chosen", 0) != 0) throw;
    throw base::Error(error.kind(), error.what() + std::string("; choose one with --label"));
  }
}

}  // namespace orbicube::cli

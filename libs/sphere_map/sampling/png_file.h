// PNG files that are compressed, by libspng (png_by_spng.cpp). Builds without it store the pixels as they are
// (png_without_spng.cpp). Meson chooses one of the two files.
#pragma once

#include <cstddef>

#include "base/array.h"
#include "base/files/stored_png.h"
#include "base/host.h"

namespace orbicube::sphere_map {

// Returns the version of libspng, NULL in builds without it.
const char* version_of_spng();

// Returns the bytes of the file: the same ones for the same image, whatever the host; another version of zlib may
// compress otherwise. Reports for each row. Throws Error "invalid-argument" when a side is not from 1 to 16384 pixels
// or sizes do not fit, "cancelled".
base::Array<std::byte> png_file(const base::PngImage& image, const base::Host& host);

}  // namespace orbicube::sphere_map

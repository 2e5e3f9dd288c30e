// NIfTI-1 (R. W. Cox et al. 2004) and NIfTI-2 in one file, of either byte order. NiftiFields are read at their offsets.
#include <bit>
#include <cmath>
#include <cstring>
#include <vector>

#include "images/image_header.h"

namespace orbicube::cli {
namespace {

class NiftiFields {
 public:
  explicit NiftiFields(std::span<const std::byte> bytes) : bytes_(bytes) {
    if (bytes.size() < 4) refuse_image("truncated", "the NIfTI header has less than 4 bytes");
    for (const bool swapped : {false, true}) {
      swapped_ = swapped;
      const auto size = get<std::int32_t>(0);
      if (size != 348 && size != 540) continue;
      is_second_ = size == 540;
      if (bytes.size() < static_cast<std::size_t>(size))
        refuse_image("truncated", "the NIfTI header ends after " + std::to_string(bytes.size()) + " of " +
                                      std::to_string(size) + " bytes");
      check_magic();
      return;
    }
    refuse_image("bad-magic", "this is no NIfTI file: its header's size is neither 348 nor 540");
  }

  bool is_second() const { return is_second_; }
  bool big_endian() const { return (std::endian::native == std::endian::big) != swapped_; }

  template <class Number>
  Number get(std::size_t offset) const {
    std::array<std::byte, sizeof(Number)> raw{};
    for (std::size_t i = 0; i < raw.size(); ++i)
      raw[i] = bytes_[offset + (swapped_ ? raw.size() - 1 - i : i)];
    return std::bit_cast<Number>(raw);
  }

  // A number that NIfTI-1 has as a First and NIfTI-2 as a Second, number i of an array.
  template <class First, class Second>
  double real(std::size_t first, std::size_t second, std::size_t i = 0) const {
    return is_second_ ? static_cast<double>(get<Second>(second + i * sizeof(Second)))
                      : static_cast<double>(get<First>(first + i * sizeof(First)));
  }

  std::int64_t length(std::size_t i) const {
    return is_second_ ? get<std::int64_t>(16 + 8 * i) : get<std::int16_t>(40 + 2 * i);
  }

 private:
  void check_magic() const {
    const std::size_t at = is_second_ ? 4 : 344;
    const char* one_file = is_second_ ? "n+2" : "n+1";
    if (std::memcmp(bytes_.data() + at, one_file, 4) == 0) return;
    if (std::memcmp(bytes_.data() + at, is_second_ ? "ni2" : "ni1", 4) == 0)
      refuse_image("unsupported", "the voxels are in a file of their own (.hdr and .img); convert it to one .nii file");
    refuse_image(
        "bad-magic",
        "the NIfTI header has no magic word n+1 or n+2; Analyze 7.5 files have no orientation and are not read");
  }

  std::span<const std::byte> bytes_;
  bool swapped_ = false, is_second_ = false;
};

VoxelType nifti_type(int code) {
  switch (code) {
    case 2:
      return VoxelType::uint8;
    case 4:
      return VoxelType::int16;
    case 8:
      return VoxelType::int32;
    case 16:
      return VoxelType::float32;
    case 64:
      return VoxelType::float64;
    case 256:
      return VoxelType::int8;
    case 512:
      return VoxelType::uint16;
    case 768:
      return VoxelType::uint32;
    case 1024:
      return VoxelType::int64;
    case 1280:
      return VoxelType::uint64;
    default:
      refuse_image("unsupported", "voxels of NIfTI data type " + std::to_string(code) + " are no labels");
  }
}

void read_nifti_sizes(const NiftiFields& f, ImageHeader& header) {
  const std::int64_t axes = f.length(0);
  if (axes < 1 || axes > 7) refuse_image("parse", "the number of axes is " + std::to_string(axes) + ", not 1 to 7");
  std::vector<std::uint64_t> sizes;
  for (std::int64_t i = 1; i <= axes; ++i) {
    const std::int64_t n = f.length(static_cast<std::size_t>(i));
    if (n < 1) refuse_image("parse", "axis " + std::to_string(i - 1) + " of the image has length " + std::to_string(n));
    sizes.push_back(static_cast<std::uint64_t>(n));
  }
  set_sizes(header, sizes);
}

// The rotation of a quaternion (a, b, c, d) with a >= 0, of which b, c and d are given.
std::array<std::array<double, 3>, 3> nifti_rotation(double b, double c, double d) {
  double a = 1 - (b * b + c * c + d * d);
  if (a < 1e-7) {
    const double scale = 1 / std::sqrt(b * b + c * c + d * d);
    b *= scale;
    c *= scale;
    d *= scale;
    a = 0;
  } else {
    a = std::sqrt(a);
  }
  return {{{a * a + b * b - c * c - d * d, 2 * b * c - 2 * a * d, 2 * b * d + 2 * a * c},
           {2 * b * c + 2 * a * d, a * a + c * c - b * b - d * d, 2 * c * d - 2 * a * b},
           {2 * b * d - 2 * a * c, 2 * c * d + 2 * a * b, a * a + d * d - c * c - b * b}}};
}

// By the standard's methods 3 (an affine map), 2 (a rotation) and 1 (the spacing alone), the first that is there.
void read_nifti_orientation(const NiftiFields& f, ImageHeader& header) {
  const double qform = f.real<std::int16_t, std::int32_t>(252, 344),
               sform = f.real<std::int16_t, std::int32_t>(254, 348);
  const auto spacing = [&](std::size_t axis) {
    const double h = std::abs(f.real<float, double>(76, 104, axis + 1));
    return h == 0 && header.size[axis] == 1 ? 1 : h;
  };
  header.space = "RAS";
  if (sform > 0) {
    for (std::size_t i = 0; i < 12; ++i)
      header.to_world[i] = f.real<float, double>(280, 400, i);
    return;
  }
  if (qform > 0) {
    const auto r = nifti_rotation(f.real<float, double>(256, 352), f.real<float, double>(256, 352, 1),
                                  f.real<float, double>(256, 352, 2));
    const double handed = f.real<float, double>(76, 104) < 0 ? -1 : 1;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double scale = axis == 2 ? handed * spacing(axis) : spacing(axis);
      set_column(header, axis, {scale * r[0][axis], scale * r[1][axis], scale * r[2][axis]});
    }
    set_column(
        header, 3,
        {f.real<float, double>(268, 376), f.real<float, double>(268, 376, 1), f.real<float, double>(268, 376, 2)});
    return;
  }
  header.space = "";
  for (std::size_t axis = 0; axis < 3; ++axis)
    header.to_world[5 * axis] = spacing(axis);
}

}  // namespace

ImageHeader nifti_header(std::span<const std::byte> bytes) {
  const NiftiFields f(bytes);
  ImageHeader header;
  header.format = f.is_second() ? "NIfTI-2" : "NIfTI-1";
  header.big_endian = f.big_endian();
  read_nifti_sizes(f, header);
  header.type = nifti_type(static_cast<int>(f.real<std::int16_t, std::int16_t>(70, 12)));
  const double begin = f.real<float, std::int64_t>(108, 168), least = f.is_second() ? 540 : 348;
  if (!(begin >= least && begin < 1e15 && begin == std::floor(begin)))
    refuse_image("parse", "the voxels begin at byte " + std::to_string(begin) + ", not after the header");
  header.data_begin = static_cast<std::uint64_t>(begin);
  const double slope = f.real<float, double>(112, 176), intercept = f.real<float, double>(116, 184);
  if (slope != 0 && std::isfinite(slope) && std::isfinite(intercept)) {
    header.slope = slope;
    header.intercept = intercept;
  }
  read_nifti_orientation(f, header);
  return header;
}

}  // namespace orbicube::cli

#include "installation/components.h"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <optional>

#include "gltf/json/compressed_view.h"
#include "images/inflate.h"
#include "session/program.h"
#include "sphere_map/sampling/png_file.h"
#ifdef ORBICUBE_WITH_VOLUME_MAP
#include "report/solver_choice.h"
#endif
#ifdef ORBICUBE_WITH_CHOLMOD
#include "linear/direct/cholmod_factor.h"
#endif

namespace orbicube::cli {
namespace {

Component library(const char* name, std::optional<std::string> version, const char* use, const char* without,
                  const char* to_install) {
  return {name, "library", version.has_value(), version.value_or(""), "", use, without, to_install};
}

Component found_at(const char* name, const char* kind, const std::optional<std::filesystem::path>& place,
                   const char* use, const char* without, const char* to_install) {
  return {name, kind, place.has_value(), "", place ? place->string() : "", use, without, to_install};
}

std::string json_version() {
  return std::to_string(NLOHMANN_JSON_VERSION_MAJOR) + "." + std::to_string(NLOHMANN_JSON_VERSION_MINOR) + "." +
         std::to_string(NLOHMANN_JSON_VERSION_PATCH);
}

std::optional<std::string> version_of_libspng() {
  const char* version = sphere_map::version_of_spng();
  return version != nullptr ? std::optional<std::string>(version) : std::nullopt;
}

std::optional<std::string> version_of_meshoptimizer() {
  const int version = gltf::version_of_meshoptimizer();
  if (version == 0) return std::nullopt;
  return std::to_string(version / 1000) + "." + std::to_string(version / 10 % 100);
}

std::optional<std::string> version_of_cholmod() {
#ifdef ORBICUBE_WITH_CHOLMOD
  return linear::cholmod_version_text();
#else
  return std::nullopt;
#endif
}

// TetGen does not say which version it is.
std::optional<std::string> version_of_tetgen() {
#ifdef ORBICUBE_WITH_TETRAHEDRA
  return "";
#else
  return std::nullopt;
#endif
}

std::optional<std::filesystem::path> module_of_petsc() {
#ifdef ORBICUBE_WITH_VOLUME_MAP
  return petsc_module();
#else
  return std::nullopt;
#endif
}

}  // namespace

std::vector<Component> components() {
  return {
      library("Eigen", ORBICUBE_EIGEN_VERSION, "sparse factors of every build", "", ""),
      library("CHOLMOD", version_of_cholmod(), "faster factors of large sparse systems",
              "Eigen factors sparse systems instead, in up to 8 times the time (42786 unknowns, CHOLMOD with OpenBLAS)",
              "libsuitesparse-dev (GPL), and build again with -Dcholmod=enabled"),
      library("TetGen", version_of_tetgen(), "tetrahedra inside closed surfaces",
              "there is no verb tetrahedralize; volume, parameterize and hex --method frames take tetrahedral meshes, "
              "but no surfaces",
              "libtet1.5-dev (AGPL), and build again with -Dtetgen=enabled"),
      library("zlib", version_of_zlib(), "compressed images, VTK XML and GIFTI files",
              "those that are compressed are refused", "zlib1g-dev, and build again with -Dzlib=enabled"),
      library("libspng", version_of_libspng(), "compressed PNG files: geometry images, atlases, plots",
              "PNG files have the same pixels without compression", "libspng-dev, and build again with -Dspng=enabled"),
      library("meshoptimizer", version_of_meshoptimizer(), "glTF files with EXT_meshopt_compression",
              "those that are compressed are refused",
              "libmeshoptimizer-dev, and build again with -Dmeshoptimizer=enabled"),
      library("stb_image", "", "textures of glTF files", "", ""),
      library("tinygltf", "", "glTF and GLB files", "", ""),
      library("nlohmann-json", json_version(), "reports", "", ""),
      library("CLI11", CLI11_VERSION, "the command line", "", ""),
      found_at("PETSc", "module", module_of_petsc(), "--solver petsc: linear systems on several processes",
               "--solver petsc is refused; the own solver of volume and untangle uses the cores of one machine",
               "petsc-dev, and build again with -Dpetsc=enabled"),
      found_at("Chromium", "program", find_browser(), "pictures: view --png", "view --png is refused; pages need none",
               "chromium"),
      found_at("xdg-open", "program", find_opener(), "opens pages: view without -o and --png",
               "view needs -o FILE.html, to be opened by hand", "xdg-utils"),
  };
}

std::string compiler() {
#if defined(__clang__)
  std::string name = "clang " + std::to_string(__clang_major__) + "." + std::to_string(__clang_minor__) + "." +
                     std::to_string(__clang_patchlevel__);
#elif defined(__GNUC__)
  std::string name = "gcc " + std::to_string(__GNUC__) + "." + std::to_string(__GNUC_MINOR__) + "." +
                     std::to_string(__GNUC_PATCHLEVEL__);
#else
  std::string name = "unknown";
#endif
  return name;
}

}  // namespace orbicube::cli

// Real surfaces, from the folder that ORBICUBE_MODELS names: each is filled, or refused for a reason that is seen in
// it.
#include <cstdlib>
#include <filesystem>

#include "mesh/files/read.h"
#include "shapes.h"

using namespace orbicube;
using namespace orbicube::test;

TEST_CASE("Real surfaces of moderate size are filled, or refused for meeting themselves") {
  const char* models = std::getenv("ORBICUBE_MODELS");
  if (models == nullptr) {
    MESSAGE("skipped: ORBICUBE_MODELS is not set");
    return;
  }
  struct Expectation {
    const char* file;
    const char* kind;  // empty: filled
  };
  for (const Expectation& expected :
       {Expectation{"spot.obj", ""}, Expectation{"torus.obj", ""}, Expectation{"double-torus.off", ""},
        Expectation{"goathead.obj", ""}, Expectation{"rod.obj", ""}, Expectation{"fandisk.obj", ""},
        Expectation{"cow.off", "self-intersection"}, Expectation{"cow-11k.obj", "self-intersection"}}) {
    CAPTURE(std::string(expected.file));
    const Surface surface(mesh::read_mesh(std::filesystem::path(models) / "dev" / expected.file, {}, host));
    if (*expected.kind != '\0') {
      CHECK(refusal(surface) == expected.kind);
    } else {
      check_kept(surface, filled(surface));
    }
  }
}

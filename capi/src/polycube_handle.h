// What a handle of a polycube map holds, for the files of its C functions.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

#include "capi/src/entry.h"
#include "orbicube/polycube.h"
#include "polycube/surface_map.h"

struct obc_polycube {
  explicit obc_polycube(const obc_host* host)
      : adapter(host), map(adapter.host().memory), energies(adapter.host().memory) {}
  orbicube::capi::HostAdapter adapter;
  orbicube::polycube::SurfaceMap map;
  std::size_t corners = 0;
  std::size_t patches = 0;
  std::int32_t construction = -1;
  orbicube::base::Array<double> energies;  // of the optimisation that it comes from
};

namespace orbicube::capi {

template <class Element, class Number>
void copy(const base::Array<Element>& from, Number* to) {
  if (to != nullptr && !from.empty()) std::memcpy(to, from.data(), from.size() * sizeof(Element));
}

}  // namespace orbicube::capi

#include "orbicube/base.h"

#include "base/version.h"
#include "capi/src/entry.h"

using namespace orbicube;

obc_status obc_host_init(obc_host* host, size_t struct_size) {
  return capi::init_versioned(host, struct_size, obc_host{});
}

const char* obc_status_name(obc_status status) {
  return base::status_name(static_cast<base::Status>(status));
}

uint32_t obc_base_version(void) {
  return base::version_number;
}

#include "orbicube/mesh.h"

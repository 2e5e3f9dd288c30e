#include "mesh/predicates.h"

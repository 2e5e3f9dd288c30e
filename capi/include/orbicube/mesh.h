#ifndef ORBICUBE_MESH_H
#define ORBICUBE_MESH_H
#include <orbicube/base.h>
#endif

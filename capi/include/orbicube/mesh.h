/* Orbicube mesh: surfaces and volumes, their files and their topology. */
#ifndef ORBICUBE_MESH_H
#define ORBICUBE_MESH_H

#include <orbicube/base.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A surface as the caller holds it: a view, kept by no function. */
typedef struct obc_surface {
  const double *positions; /* x y z a vertex */
  size_t vertex_count;
  const uint32_t *triangles; /* three vertex indices each, counter-clockwise seen from outside */
  size_t triangle_count;
} obc_surface;

#ifdef __cplusplus
}
#endif

#endif

// What is measured of a frame field: as figures of a report, and as lines to read.
#pragma once

#include "frame_field/frame_field.h"
#include "frame_field/graph/boundary_indices.h"
#include "frame_field/singularities/measurement.h"
#include "frame_field/singularities/meshability.h"
#include "frame_field/singularities/singularities.h"
#include "session/session.h"

namespace orbicube::cli {

struct FieldFindings {
  FieldFindings(const mesh::Mesh& solid, const mesh::TetrahedralConnectivity& connectivity,
                const frame_field::Field& field, const base::Host& host);

  frame_field::Measurement measurement;
  frame_field::SingularGraph graph;
  frame_field::BoundaryIndices indices;
  frame_field::Meshability local;
};

// `exponent`: of the power of two by which the solid was scaled.
Json field_figures(const mesh::Mesh& solid, const FieldFindings& found, int exponent);
Json repair_figures(const frame_field::RepairOutcome& repair);

void say_field(const FieldFindings& found, Session& session);
void say_repair(const frame_field::RepairOutcome& repair, Session& session);

}  // namespace orbicube::cli

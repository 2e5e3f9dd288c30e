"""
Orbicube: maps of surfaces to spheres and polycubes, harmonics, frame fields, and the solvers underneath. `Orbicube.Raw` has the C
functions as they are.
"""
module Orbicube

export OrbicubeError, EvaluationFailed, StopRun
export TrustRegion, ProjectedGradient, SphereOptimizer, optimize, least_squares, only_fg!, project
export minimizer, converged, iterations, f_calls, stop_reason, report
export Run, ask!, tell!, result, multipliers, save, load
export Surface, make_surface, read_surface, write_surface, topology, sphere_map, measure_map
export Locator, locate, sample, remesh, fit_harmonics, synthesize, frame_field
export PolycubeMap, polycube, polycube_on, certify_polycube, common_polycube, optimize_domain, optimize_corners, meet_features
export energies, polycube_graph, polycube_quads, untangle

include("raw.jl")
include("call.jl")
include("solvers.jl")
include("maps.jl")
include("polycubes.jl")
include("volumes.jl")

end

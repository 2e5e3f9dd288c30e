# What <orbicube/untangle.h> declares. Written by scripts/bindings.py; not to be edited.

mutable struct obc_untangle_options <: CStruct
    struct_size::UInt32
    max_steps::Int32
    max_polish_steps::Int32
    free_boundary::Int32
    volume_weight::Float64
    tolerance::Float64
    obc_untangle_options() = zeroed!(new())
end

mutable struct obc_untangle_report <: CStruct
    struct_size::UInt32
    first_inverted::UInt32
    inverted_before::UInt64
    inverted::UInt64
    steps::UInt64
    polish_steps::UInt64
    min_determinant::Float64
    max_determinant::Float64
    energy::Float64
    obc_untangle_report() = zeroed!(new())
end

mutable struct obc_untangle_tetrahedra_problem <: CStruct
    struct_size::UInt32
    reserved::Int32
    positions::Ptr{Float64}
    vertex_count::Csize_t
    tetrahedra::Ptr{UInt32}
    tetrahedron_count::Csize_t
    rest::Ptr{Float64}
    fixed::Ptr{UInt8}
    fixed_coordinates::Ptr{UInt8}
    ties::Ptr{UInt32}
    obc_untangle_tetrahedra_problem() = zeroed!(new())
end

mutable struct obc_untangle_triangles_problem <: CStruct
    struct_size::UInt32
    reserved::Int32
    positions::Ptr{Float64}
    vertex_count::Csize_t
    triangles::Ptr{UInt32}
    triangle_count::Csize_t
    rest::Ptr{Float64}
    fixed::Ptr{UInt8}
    fixed_coordinates::Ptr{UInt8}
    ties::Ptr{UInt32}
    obc_untangle_triangles_problem() = zeroed!(new())
end

const address_obc_untangle_options_init = Ref(C_NULL)
obc_untangle_options_init(options, struct_size) =
    ccall(symbol(address_obc_untangle_options_init, :untangle, :obc_untangle_options_init), Int32, (Ptr{obc_untangle_options}, Csize_t), options, struct_size)

const address_obc_untangle_report_init = Ref(C_NULL)
obc_untangle_report_init(report, struct_size) =
    ccall(symbol(address_obc_untangle_report_init, :untangle, :obc_untangle_report_init), Int32, (Ptr{obc_untangle_report}, Csize_t), report, struct_size)

const address_obc_untangle_tetrahedra_problem_init = Ref(C_NULL)
obc_untangle_tetrahedra_problem_init(problem, struct_size) =
    ccall(symbol(address_obc_untangle_tetrahedra_problem_init, :untangle, :obc_untangle_tetrahedra_problem_init), Int32, (Ptr{obc_untangle_tetrahedra_problem}, Csize_t), problem, struct_size)

const address_obc_untangle_tetrahedra = Ref(C_NULL)
obc_untangle_tetrahedra(problem, options, host, result, report, error) =
    ccall(symbol(address_obc_untangle_tetrahedra, :untangle, :obc_untangle_tetrahedra), Int32, (Ptr{obc_untangle_tetrahedra_problem}, Ptr{obc_untangle_options}, Ptr{obc_host}, Ptr{Float64}, Ptr{obc_untangle_report}, Ptr{obc_error}), problem, options, host, result, report, error)

const address_obc_untangle_triangles_problem_init = Ref(C_NULL)
obc_untangle_triangles_problem_init(problem, struct_size) =
    ccall(symbol(address_obc_untangle_triangles_problem_init, :untangle, :obc_untangle_triangles_problem_init), Int32, (Ptr{obc_untangle_triangles_problem}, Csize_t), problem, struct_size)

const address_obc_untangle_triangles = Ref(C_NULL)
obc_untangle_triangles(problem, options, host, result, report, error) =
    ccall(symbol(address_obc_untangle_triangles, :untangle, :obc_untangle_triangles), Int32, (Ptr{obc_untangle_triangles_problem}, Ptr{obc_untangle_options}, Ptr{obc_host}, Ptr{Float64}, Ptr{obc_untangle_report}, Ptr{obc_error}), problem, options, host, result, report, error)

const address_obc_untangle_refine_tetrahedra = Ref(C_NULL)
obc_untangle_refine_tetrahedra(problem, options, host, out, report, error) =
    ccall(symbol(address_obc_untangle_refine_tetrahedra, :untangle, :obc_untangle_refine_tetrahedra), Int32, (Ptr{obc_untangle_tetrahedra_problem}, Ptr{obc_untangle_options}, Ptr{obc_host}, Ptr{Ptr{Cvoid}}, Ptr{obc_untangle_report}, Ptr{obc_error}), problem, options, host, out, report, error)

const address_obc_untangle_refine_triangles = Ref(C_NULL)
obc_untangle_refine_triangles(problem, options, host, out, report, error) =
    ccall(symbol(address_obc_untangle_refine_triangles, :untangle, :obc_untangle_refine_triangles), Int32, (Ptr{obc_untangle_triangles_problem}, Ptr{obc_untangle_options}, Ptr{obc_host}, Ptr{Ptr{Cvoid}}, Ptr{obc_untangle_report}, Ptr{obc_error}), problem, options, host, out, report, error)

const address_obc_untangle_refined_destroy = Ref(C_NULL)
obc_untangle_refined_destroy(refined) =
    ccall(symbol(address_obc_untangle_refined_destroy, :untangle, :obc_untangle_refined_destroy), Cvoid, (Ptr{Cvoid},), refined)

const address_obc_untangle_refined_vertex_count = Ref(C_NULL)
obc_untangle_refined_vertex_count(refined) =
    ccall(symbol(address_obc_untangle_refined_vertex_count, :untangle, :obc_untangle_refined_vertex_count), Csize_t, (Ptr{Cvoid},), refined)

const address_obc_untangle_refined_element_count = Ref(C_NULL)
obc_untangle_refined_element_count(refined) =
    ccall(symbol(address_obc_untangle_refined_element_count, :untangle, :obc_untangle_refined_element_count), Csize_t, (Ptr{Cvoid},), refined)

const address_obc_untangle_refined_copy = Ref(C_NULL)
obc_untangle_refined_copy(refined, positions, elements, parents, origins, weights, error) =
    ccall(symbol(address_obc_untangle_refined_copy, :untangle, :obc_untangle_refined_copy), Int32, (Ptr{Cvoid}, Ptr{Float64}, Ptr{UInt32}, Ptr{UInt32}, Ptr{UInt32}, Ptr{Float64}, Ptr{obc_error}), refined, positions, elements, parents, origins, weights, error)

const address_obc_untangle_version = Ref(C_NULL)
obc_untangle_version() =
    ccall(symbol(address_obc_untangle_version, :untangle, :obc_untangle_version), UInt32, ())

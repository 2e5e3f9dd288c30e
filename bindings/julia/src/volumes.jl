# Maps of solids.

"""
    positions, report = untangle(positions, tetrahedra; rest, fixed, ties, keep_best=false, options...)

Moves vertices until every tetrahedron (4 by m, from 1) is positive. rest: positions where each has the shape that it should have. fixed: a
flag a coordinate (3 by n) or a vertex (n). ties: a group a coordinate (3 by n), from 1 to 3 n, of which all are to be equal, or 0. Where some
stay inverted an OrbicubeError is thrown or, with `keep_best`, the best is answered: `report.inverted` says how many. Options: steps,
polish_steps, volume_weight.
"""
function untangle(positions::AbstractMatrix, tetrahedra::AbstractMatrix{<:Integer}; rest=nothing, fixed=nothing, ties=nothing,
                  keep_best=false, threads=0, progress=nothing, options...)
    n, m = columns(positions, 3, "positions"), columns(tetrahedra, 4, "tetrahedra")
    all(v -> 1 <= v <= n, tetrahedra) || throw(ArgumentError("tetrahedra: numbers of vertices from 1 to $n are needed"))
    places, cells = doubles(positions), UInt32.(tetrahedra .- 1)
    tangle = filled(Raw.obc_volume_map_tangle, Raw.obc_volume_map_tangle_init, NamedTuple())
    tangle.positions, tangle.vertex_count = pointer(places), n
    tangle.tetrahedra, tangle.tetrahedron_count = pointer(cells), m
    shape, flags, groups = zeros(0, 0), UInt8[], UInt32[]
    if rest !== nothing
        expect(columns(rest, 3, "rest"), n, "columns of rest")
        shape = doubles(rest)
        tangle.rest = pointer(shape)
    end
    if fixed !== nothing
        expect(size(fixed, ndims(fixed)), n, "columns of fixed")
        flags = ndims(fixed) == 1 ? repeat(UInt8.(fixed .!= 0), inner=3) : vec(UInt8.(fixed .!= 0))
        expect(length(flags), 3 * n, "fixed")
        tangle.fixed = pointer(flags)
    end
    if ties !== nothing
        expect(length(ties), 3 * n, "ties")
        groups = UInt32[group == 0 ? typemax(UInt32) : group - 1 for group in ties]
        tangle.ties = pointer(groups)
    end
    chosen = filled(Raw.obc_volume_map_untangle_options, Raw.obc_volume_map_untangle_options_init, values(options))
    report = filled(Raw.obc_volume_map_untangle_report, Raw.obc_volume_map_untangle_report_init, NamedTuple())
    result = Matrix{Float64}(undef, 3, n)
    try
        GC.@preserve places cells shape flags groups hosted(threads=threads, progress=progress) do lent, error
            Raw.obc_volume_map_untangle(tangle, chosen, lent, result, report, error)
        end
    catch error
        keep_best && error isa OrbicubeError && error.status == Raw.OBC_NO_VALID_RESULT || rethrow()
    end
    result, report
end

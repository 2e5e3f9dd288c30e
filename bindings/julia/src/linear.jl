# Sparse symmetric positive definite systems: factors that follow small changes, and iterations.

# The lower triangle by rows, which is the upper triangle by columns: column i of `upper` is row i of C's matrix.
struct LinearMatrix
    upper::SparseMatrixCSC{Float64,Int}
    row_begin::Vector{Csize_t}
    columns::Vector{UInt32}
end

# Entries (i, j) and (j, i) may differ by this fraction of sqrt(A[i, i] A[j, j]), which bounds the entries of a positive
# definite matrix: sums of products in another order, as of B' D B, differ by less, and mistakes by more.
const symmetry = 1e-12

function LinearMatrix(A::AbstractMatrix)
    n = size(A, 1)
    size(A, 2) == n || throw(DimensionMismatch("A: a square matrix is needed, not $(size(A))"))
    I, J, V = findnz(convert(SparseMatrixCSC{Float64,Int}, sparse(A)))
    below = I .>= J
    above = .!below
    upper = sparse([J[below]; I[above]], [I[below]; J[above]], [V[below]; zeros(count(above))], n, n)
    if any(above)
        mirrored = sparse([J[below]; I[above]], [I[below]; J[above]], [zeros(count(below)); V[above]], n, n)
        require_symmetric(upper, mirrored)
    end
    for i in 1:n
        range = nzrange(upper, i)
        (isempty(range) || rowvals(upper)[last(range)] != i) &&
            throw(ArgumentError("A has no entry on the diagonal of row $i: A[$i, $i] must be positive"))
    end
    LinearMatrix(upper, Csize_t.(upper.colptr .- 1), UInt32.(rowvals(upper) .- 1))
end

function require_symmetric(lower, mirrored)
    scale = zeros(size(lower, 1))
    for i in axes(lower, 2), k in nzrange(lower, i)
        rowvals(lower)[k] == i && (scale[i] = sqrt(abs(nonzeros(lower)[k])))
    end
    for i in axes(lower, 2), k in nzrange(lower, i)
        j, a, b = rowvals(lower)[k], nonzeros(lower)[k], nonzeros(mirrored)[k]
        j != i && abs(a - b) > symmetry * scale[i] * scale[j] &&
            throw(ArgumentError("A is not symmetric: A[$i, $j] is $a and A[$j, $i] is $b; give a symmetric matrix or its lower " *
                                "triangle alone"))
    end
end

# f(pointer to the obc_linear_matrix)
function with_matrix(f, matrix::LinearMatrix)
    values = nonzeros(matrix.upper)
    view = Ref(Raw.obc_linear_matrix(size(matrix.upper, 1), pointer(matrix.row_begin), pointer(matrix.columns), pointer(values)))
    GC.@preserve matrix values view f(struct_pointer(view))
end

"""
    LinearFactor(A; method=:auto)
    x = solve(factor, b)            or factor \\ b; of a matrix b, for each of its columns

The factor L D L' of a sparse symmetric positive definite matrix: the whole matrix or its lower triangle alone. `refactor!`, `remove_row!`
and `update!` change it. Methods: `:eigen`, and in builds with CHOLMOD `:cholmod_simplicial` and `:cholmod_supernodal`.
"""
mutable struct LinearFactor
    handle::Ptr{Cvoid}
    pattern::SparseMatrixCSC{Float64,Int}
    function LinearFactor(A::AbstractMatrix; options...)
        chosen = filled(Raw.obc_linear_direct_options, Raw.obc_linear_direct_options_init, values(options))
        matrix, out = LinearMatrix(A), Ref(C_NULL)
        with_matrix(view -> checked(error -> Raw.obc_linear_direct_create(view, chosen, C_NULL, out, error)), matrix)
        finalizer(it -> released(Raw.obc_linear_direct_destroy, it.handle), new(out[], matrix.upper))
    end
end

Base.size(factor::LinearFactor) = size(factor.pattern)
Base.size(factor::LinearFactor, dimension::Integer) = size(factor.pattern, dimension)
Base.show(io::IO, factor::LinearFactor) = print(io, "LinearFactor of ", size(factor, 1), " rows, ", entry_count(factor), " entries")

"The solution of A x = b, for each column of b."
function solve(factor::LinearFactor, b::AbstractVecOrMat)
    size(b, 1) == size(factor, 1) || throw(DimensionMismatch("b: $(size(factor, 1)) rows are needed, not $(size(b))"))
    right = doubles(b)
    x = similar(right)
    GC.@preserve factor checked(error -> Raw.obc_linear_direct_solve(factor.handle, size(right, 2), right, x, error))
    x
end
Base.:\(factor::LinearFactor, b::AbstractVecOrMat) = solve(factor, b)

"Factorizes a matrix of the same pattern, or of fewer entries. Removed rows and updates do not remain."
function refactor!(factor::LinearFactor, A::AbstractMatrix)
    old, new = factor.pattern, LinearMatrix(A).upper
    size(new) == size(old) || throw(DimensionMismatch("A: $(size(old, 1)) rows are needed as before, not $(size(new, 1))"))
    numbers = zeros(nnz(old))
    for i in axes(new, 2), k in nzrange(new, i)
        j, range = rowvals(new)[k], nzrange(old, i)
        place = first(range) - 1 + searchsortedfirst(view(rowvals(old), range), j)
        (place in range && rowvals(old)[place] == j) ||
            throw(ArgumentError("A[$i, $j] is not in the pattern of the factor: make a new LinearFactor"))
        numbers[place] = nonzeros(new)[k]
    end
    GC.@preserve factor checked(error -> Raw.obc_linear_direct_refactor(factor.handle, numbers, length(numbers), error))
    factor
end

"Replaces a row and its column by those of the identity, as for an unknown that becomes known."
function remove_row!(factor::LinearFactor, row::Integer)
    1 <= row <= size(factor, 1) || throw(ArgumentError("row $row is not within 1 to $(size(factor, 1))"))
    GC.@preserve factor checked(error -> Raw.obc_linear_direct_remove_row(factor.handle, row - 1, error))
    factor
end

"""
    update!(factor, rows, values; sign=1)

Adds `sign * w * w'` to the matrix, for the w with these entries. The matrix stores an entry, which may be 0, for any two of the rows.
"""
function update!(factor::LinearFactor, rows::AbstractVector{<:Integer}, values::AbstractVector; sign::Integer=1)
    expect(length(values), length(rows), "values")
    all(row -> 1 <= row <= size(factor, 1), rows) || throw(ArgumentError("rows are not all within 1 to $(size(factor, 1))"))
    sign in (1, -1) || throw(ArgumentError("sign = $sign: 1 or -1 is needed"))
    GC.@preserve factor checked(error -> Raw.obc_linear_direct_update(factor.handle, UInt32.(rows .- 1), doubles(values),
                                                                      length(rows), sign, error))
    factor
end

"The number of entries of L below its diagonal."
entry_count(factor::LinearFactor) = GC.@preserve factor Int(Raw.obc_linear_direct_entry_count(factor.handle))

# The C solver keeps what it reports to: one object as long as the solver lives, with the function of the call that runs.
kept_progress() = @cfunction(reported, Int32, (Cstring, UInt64, UInt64, Float64, Ref{Report{Any}}))
quiet(at...) = true

function reporting(f, report::Report{Any}, progress)
    report.f, report.caught = progress === nothing ? quiet : progress, Caught()
    error = Raw.obc_error()
    status = GC.@preserve report f(error)
    caught = report.caught
    report.f, report.caught = quiet, Caught()
    rethrown(caught)
    check(status, error)
end

"""
    LinearIterations(A; method=:auto, block_size=1, tolerance=1e-8, max_iterations=1000, threads=0, progress)
    x, report = solve(solver, b; progress)

Conjugate gradients for a sparse symmetric positive definite matrix, the whole or its lower triangle alone, with symmetric Gauss-Seidel
(`:gauss_seidel`) or algebraic multigrid (`:multigrid`). The report has `converged`, `iterations` and `residual`, |b - A x| / |b|.
"""
mutable struct LinearIterations
    handle::Ptr{Cvoid}
    size::Int
    report::Report{Any}
    function LinearIterations(A::AbstractMatrix; threads::Integer=0, progress=nothing, options...)
        chosen = filled(Raw.obc_linear_iterative_options, Raw.obc_linear_iterative_options_init, values(options))
        matrix, out, report = LinearMatrix(A), Ref(C_NULL), Report{Any}(quiet, Caught())
        host = Raw.obc_host()
        Raw.obc_host_init(host, sizeof(host))
        host.thread_count = threads
        host.progress, host.progress_user = kept_progress(), pointer_from_objref(report)
        with_matrix(matrix) do view
            reporting(error -> Raw.obc_linear_iterative_create(view, chosen, host, out, error), report, progress)
        end
        finalizer(it -> released(Raw.obc_linear_iterative_destroy, it.handle), new(out[], size(A, 1), report))
    end
end

function solve(solver::LinearIterations, b::AbstractVector; progress=nothing)
    expect(length(b), solver.size, "b")
    right, x = doubles(b), Vector{Float64}(undef, solver.size)
    figures = filled(Raw.obc_linear_iterative_report, Raw.obc_linear_iterative_report_init, NamedTuple())
    GC.@preserve solver reporting(solver.report, progress) do error
        Raw.obc_linear_iterative_solve(solver.handle, right, x, figures, error)
    end
    x, figures
end

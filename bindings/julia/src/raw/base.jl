# What <orbicube/base.h> declares. Written by scripts/bindings.py; not to be edited.

const OBC_OK = Int32(0)
const OBC_INVALID_ARGUMENT = Int32(-1)
const OBC_MALFORMED_FILE = Int32(-2)
const OBC_NOT_CLOSED = Int32(-3)
const OBC_NOT_MANIFOLD = Int32(-4)
const OBC_WRONG_GENUS = Int32(-5)
const OBC_DEGENERATE = Int32(-6)
const OBC_OUT_OF_MEMORY = Int32(-7)
const OBC_CANCELLED = Int32(-8)
const OBC_IO = Int32(-9)
const OBC_UNSUPPORTED = Int32(-10)
const OBC_NO_VALID_RESULT = Int32(-11)
const OBC_INTERNAL = Int32(-12)

mutable struct obc_error <: CStruct
    status::Int32
    kind::NTuple{28, UInt8}
    message::NTuple{480, UInt8}
    obc_error() = zeroed!(new())
end

struct obc_allocator
    allocate::Ptr{Cvoid}
    release::Ptr{Cvoid}
    user::Ptr{Cvoid}
end

mutable struct obc_host <: CStruct
    struct_size::UInt32
    thread_count::UInt32
    progress::Ptr{Cvoid}
    progress_user::Ptr{Cvoid}
    log::Ptr{Cvoid}
    log_user::Ptr{Cvoid}
    parallel_for::Ptr{Cvoid}
    parallel_for_user::Ptr{Cvoid}
    allocator::Ptr{obc_allocator}
    fraction::Ptr{Float64}
    obc_host() = zeroed!(new())
end

const address_obc_host_init = Ref(C_NULL)
obc_host_init(host, struct_size) =
    ccall(symbol(address_obc_host_init, :base, :obc_host_init), Int32, (Ptr{obc_host}, Csize_t), host, struct_size)

const address_obc_status_name = Ref(C_NULL)
obc_status_name(status) =
    ccall(symbol(address_obc_status_name, :base, :obc_status_name), Cstring, (Int32,), status)

const address_obc_base_version = Ref(C_NULL)
obc_base_version() =
    ccall(symbol(address_obc_base_version, :base, :obc_base_version), UInt32, ())

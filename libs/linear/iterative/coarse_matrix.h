// The matrix of multigrid's next level: sums of blocks over aggregates of rows (aggregation.h).
#pragma once

#include "base/host.h"
#include "linear/block_matrix.h"

namespace orbicube::linear {

// Row v of the matrix goes to row aggregate[v] of `coarse`, which has `count`; rows with no_index are left out. Shared
// unknowns stay.
template <int block>
void make_coarse(const BlockMatrix<block>& matrix, const Array<Index>& aggregate, std::size_t count,
                 BlockMatrix<block>& coarse, const base::Host& host);

extern template void make_coarse<1>(const BlockMatrix<1>&, const Array<Index>&, std::size_t, BlockMatrix<1>&,
                                    const base::Host&);
extern template void make_coarse<2>(const BlockMatrix<2>&, const Array<Index>&, std::size_t, BlockMatrix<2>&,
                                    const base::Host&);
extern template void make_coarse<3>(const BlockMatrix<3>&, const Array<Index>&, std::size_t, BlockMatrix<3>&,
                                    const base::Host&);

}  // namespace orbicube::linear

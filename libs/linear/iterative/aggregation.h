// Aggregates of rows that are coupled strongly: the rows of multigrid's next level.
#pragma once

#include "base/host.h"
#include "linear/block_matrix.h"

namespace orbicube::linear {

// From each row that is left, in their order, grows an aggregate of about eight by what is coupled most to all of it.
// What remains alone joins the neighbor that it is coupled most to. `aggregate` gets the aggregate of each row,
// no_index for rows without unknowns of their own. Returns the number of aggregates.
template <int block>
std::size_t make_aggregates(const BlockMatrix<block>& matrix, Array<Index>& aggregate, const base::Host& host);

extern template std::size_t make_aggregates<1>(const BlockMatrix<1>&, Array<Index>&, const base::Host&);
extern template std::size_t make_aggregates<2>(const BlockMatrix<2>&, Array<Index>&, const base::Host&);
extern template std::size_t make_aggregates<3>(const BlockMatrix<3>&, Array<Index>&, const base::Host&);

}  // namespace orbicube::linear

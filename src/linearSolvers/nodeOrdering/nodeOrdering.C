/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

\*---------------------------------------------------------------------------*/

#include "nodeOrdering.H"
#include "Pstream.H"
#include "ListListOps.H"

#include <metis.h>
#include <algorithm>
#include <type_traits>

static_assert
(
    std::is_same<idx_t, Foam::label>::value,
    "METIS and OpenFOAM differ in the size of their integers"
);


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::nodeOrdering::graph Foam::nodeOrdering::compress
(
    const labelUList& row,
    const labelUList& col
) const
{
    const label n = nNodes();

    // Counting sort by row
    labelList offset(n + 1, Zero);
    forAll(row, k)
    {
        ++offset[row[k] + 1];
    }
    for (label i = 0; i < n; ++i)
    {
        offset[i + 1] += offset[i];
    }

    labelList sorted(row.size());
    {
        labelList next(SubList<label>(offset, n));
        forAll(row, k)
        {
            sorted[next[row[k]]++] = col[k];
        }
    }

    // Keep each column's first occurrence
    graph g;
    g.offset.setSize(n + 1, Zero);
    labelList seenBy(n, label(-1));
    label nKept = 0;

    for (label i = 0; i < n; ++i)
    {
        seenBy[i] = i;
        for (label k = offset[i]; k < offset[i + 1]; ++k)
        {
            const label j = sorted[k];
            if (seenBy[j] != i)
            {
                seenBy[j] = i;
                sorted[nKept++] = j;
            }
        }
        g.offset[i + 1] = nKept;
    }
    sorted.setSize(nKept);
    g.col.transfer(sorted);

    return g;
}


void Foam::nodeOrdering::nodePairs
(
    const feMatrixPattern& pattern,
    labelList& row,
    labelList& col
) const
{
    labelList nodeOf(start_.last());
    for (label node = 0; node < nNodes(); ++node)
    {
        std::fill
        (
            nodeOf.begin() + start_[node],
            nodeOf.begin() + start_[node + 1],
            node
        );
    }

    // Triplets come in runs of equal nodes: drop repeats as they come
    const label nTriplets = pattern.row.size();
    row.setSize(nTriplets);
    col.setSize(nTriplets);
    label n = 0;

    for (label k = 0; k < nTriplets; ++k)
    {
        const label i = nodeOf[pattern.row[k]];
        const label j = nodeOf[pattern.col[k]];

        if (i != j && (n == 0 || row[n - 1] != i || col[n - 1] != j))
        {
            row[n] = i;
            col[n] = j;
            ++n;
        }
    }
    row.setSize(n);
    col.setSize(n);

    const graph g(compress(row, col));

    row.setSize(g.col.size());
    col = g.col;
    for (label i = 0; i < nNodes(); ++i)
    {
        std::fill(row.begin() + g.offset[i], row.begin() + g.offset[i + 1], i);
    }
}


Foam::labelList Foam::nodeOrdering::dissect(const graph& g) const
{
    label n = nNodes();
    labelList order(identity(n));

    // METIS fails on graphs without edges
    if (n < 2 || g.col.empty())
    {
        return order;
    }

    labelList weight(n), inverse(n);
    forAll(weight, node)
    {
        weight[node] = start_[node + 1] - start_[node];
    }

    idx_t options[METIS_NOPTIONS];
    METIS_SetDefaultOptions(options);
    options[METIS_OPTION_NUMBERING] = 0;

    const int status = METIS_NodeND
    (
        &n,
        const_cast<label*>(g.offset.cdata()),
        const_cast<label*>(g.col.cdata()),
        weight.data(),
        options,
        order.data(),
        inverse.data()
    );

    if (status != METIS_OK)
    {
        WarningInFunction
            << "METIS failed with status " << status
            << ": keeping the natural order" << endl;
        order = identity(n);
    }

    return order;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::nodeOrdering::nodeOrdering(const feMatrixPattern& pattern)
{
    const label nUnknowns = pattern.unknowns.size();

    List<labelList> starts(Pstream::nProcs());
    starts[Pstream::myProcNo()] = pattern.nodeStart;
    Pstream::gatherList(starts);
    Pstream::scatterList(starts);

    start_ = ListListOps::combine<labelList>(starts, accessOp<labelList>());

    if (start_.empty())
    {
        start_ = identity(nUnknowns);
    }
    start_.append(nUnknowns);
    std::sort(start_.begin(), start_.end());

    if (start_.first() != 0)
    {
        FatalErrorInFunction
            << "The first node starts with unknown " << start_.first()
            << " in place of 0" << abort(FatalError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::labelList Foam::nodeOrdering::positions
(
    const feMatrixPattern& pattern
) const
{
    List<labelList> rows(Pstream::nProcs()), cols(Pstream::nProcs());
    nodePairs(pattern, rows[Pstream::myProcNo()], cols[Pstream::myProcNo()]);
    Pstream::gatherList(rows);
    Pstream::gatherList(cols);

    if (!Pstream::master())
    {
        return labelList();
    }

    // Both directions: METIS wants a symmetric graph
    const labelList row
    (
        ListListOps::combine<labelList>(rows, accessOp<labelList>())
    );
    const labelList col
    (
        ListListOps::combine<labelList>(cols, accessOp<labelList>())
    );
    rows.clear();
    cols.clear();

    labelList from(row), to(col);
    from.append(col);
    to.append(row);

    const labelList order(dissect(compress(from, to)));

    labelList position(start_.last());
    label next = 0;
    for (const label node : order)
    {
        for (label i = start_[node]; i < start_[node + 1]; ++i)
        {
            position[i] = next++;
        }
    }

    return position;
}


// ************************************************************************* //

/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "partition.H"
#include "boolList.H"
#include "DynamicList.H"
#include "error.H"
#include <metis.h>
#include <type_traits>

static_assert
(
    std::is_same<idx_t, Foam::label>::value,
    "METIS and OpenFOAM differ in the size of their integers"
);

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

static bool connected(const labelUList& start, const labelUList& neighbour)
{
    boolList met(start.size() - 1, false);
    DynamicList<label> front(1, label(0));
    met[0] = true;
    label nMet = 1;
    while (front.size())
    {
        const label i = front.remove();
        for (label k = start[i]; k < start[i + 1]; ++k)
        {
            const label j = neighbour[k];
            if (met[j]) continue;
            met[j] = true;
            ++nMet;
            front.append(j);
        }
    }
    return nMet == met.size();
}


//- Weights as integers, the mean about a hundred where their sum allows
static labelList integers(const UList<scalar>& weight)
{
    scalar total = 0;
    for (const scalar w : weight) total += w;
    const scalar scale = min(100.0*weight.size(), 1e9)/total;

    labelList n(weight.size());
    forAll(n, i) n[i] = max(label(1), label(weight[i]*scale + 0.5));
    return n;
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::labelList Foam::partSizes(const labelUList& part, const label nParts)
{
    labelList n(nParts, 0);
    for (const label p : part) ++n[p];
    return n;
}


Foam::labelList Foam::partition
(
    const labelUList& start,
    const labelUList& neighbour,
    const UList<scalar>& weight,
    const label nParts,
    const UList<scalar>& shares
)
{
    idx_t n = start.size() - 1, nConstraints = 1, k = nParts, cut = 0;
    labelList part(n, 0);
    if (nParts == 1 || !n) return part;

    labelList w(integers(weight));
    List<real_t> share(shares.size());
    forAll(share, i) share[i] = shares[i];

    idx_t options[METIS_NOPTIONS];
    METIS_SetDefaultOptions(options);
    options[METIS_OPTION_CONTIG] = connected(start, neighbour);

    const auto cutWith = [&](const auto& method)
    {
        const int status = method
        (
            &n, &nConstraints,
            const_cast<label*>(start.cdata()), const_cast<label*>(neighbour.cdata()),
            w.data(), nullptr, nullptr, &k, share.empty() ? nullptr : share.data(),
            nullptr, options, &cut, part.data()
        );
        if (status != METIS_OK)
        {
            FatalErrorInFunction
                << "METIS failed with status " << status << " for a graph of "
                << n << " vertices and " << nParts << " parts" << exit(FatalError);
        }
    };
    cutWith(METIS_PartGraphKway);

    // Small graphs: bisection leaves no part empty, but may leave one in pieces
    if (partSizes(part, nParts).found(0))
    {
        options[METIS_OPTION_CONTIG] = 0;
        cutWith(METIS_PartGraphRecursive);
    }
    return part;
}


// ************************************************************************* //

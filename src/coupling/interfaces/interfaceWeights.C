/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "interfaceWeights.H"
#include <algorithm>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(interfaceWeights, 0);
    defineRunTimeSelectionTable(interfaceWeights, dictionary);
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

Foam::List<Foam::interfaceSurface::term> Foam::interfaceWeights::summed
(
    DynamicList<term>& terms
)
{
    std::stable_sort
    (
        terms.begin(), terms.end(),
        [](const term& s, const term& t) { return s.node < t.node; }
    );
    DynamicList<term> once;
    for (const term& t : terms)
    {
        if (once.size() && once.last().node == t.node) once.last().weight += t.weight;
        else once.append(t);
    }
    return once;
}


Foam::List<Foam::interfaceSurface::term> Foam::interfaceWeights::collected
(
    DynamicList<term>& terms
)
{
    List<term> once(summed(terms));

    // What goes by round-off goes to the largest, so that the sum stays
    label largest = 0, n = 0;
    forAll(once, i) if (mag(once[i].weight) > mag(once[largest].weight)) largest = i;
    term& most = once[largest];
    forAll(once, i) if (mag(once[i].weight) < 1e-12) most.weight += once[i].weight;
    for (const term& t : once) if (mag(t.weight) >= 1e-12) once[n++] = t;
    once.setSize(n);
    return once;
}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::interfaceWeights> Foam::interfaceWeights::New(const dictionary& dict)
{
    const word type(dict.lookupOrDefault<word>("weights", "mortar"));
    auto cstrIter = dictionaryConstructorTablePtr_->cfind(type);
    if (!cstrIter.found())
    {
        FatalIOErrorInLookup
        (
            dict, "weights", type, *dictionaryConstructorTablePtr_
        ) << exit(FatalIOError);
    }
    return cstrIter()(dict);
}


// ************************************************************************* //

/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "interpolationWeights.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(interpolationWeights, 0);
    addToRunTimeSelectionTable(interfaceWeights, interpolationWeights, dictionary);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::List<Foam::List<Foam::interfaceSurface::term>> Foam::interpolationWeights::rows
(
    const interfaceFit& fit,
    const labelUList& nodes
) const
{
    List<List<term>> rows(nodes.size());
    forAll(nodes, i)
    {
        if (fit.isBare(nodes[i])) continue;
        const point& x = fit.x()[nodes[i]];
        DynamicList<term> terms;
        fit.partner().addTerms(fit.partner().project(x), x, 1, terms);
        rows[i] = collected(terms);
    }
    return rows;
}


// ************************************************************************* //

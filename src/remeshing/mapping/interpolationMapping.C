/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "interpolationMapping.H"
#include "addToRunTimeSelectionTable.H"
#include "unknownEntries.H"
#include "OStringStream.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace meshMappings
{
    defineTypeNameAndDebug(interpolation, 0);
    addToRunTimeSelectionTable(meshMapping, interpolation, dictionary);
    defineTypeNameAndDebug(projection, 0);
    addToRunTimeSelectionTable(meshMapping, projection, dictionary);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::string Foam::meshMappings::interpolation::outside
(
    const point& x,
    const elementSearch::place& nearest
) const
{
    OStringStream os;
    os  << "a node at " << x << " is outside of the mesh with the values";
    if (nearest.moved < GREAT)
    {
        os  << ", by " << nearest.moved << " of the size of the nearest element; the tolerance of the mapping is "
            << tolerance_;
    }
    return os.str();
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::meshMappings::interpolation::interpolation(const dictionary& coeffs)
:
    tolerance_(coeffs.getOrDefault<scalar>("tolerance", 0.1))
{
    reportUnknownEntries(coeffs, {"tolerance"});
    if (!(tolerance_ > 0 && tolerance_ < GREAT))
    {
        FatalIOErrorInFunction(coeffs)
            << "tolerance is " << tolerance_ << ", expected a number > 0" << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::string Foam::meshMappings::interpolation::map(const source& old, const feMesh& now, stateMap& m) const
{
    const auto setSize = [](valueMap& map, const label n)
    {
        map.from.setSize(n);
        map.weight.setSize(n);
    };
    const auto keep = [](valueMap& map, const label i, const label from)
    {
        map.from[i] = labelList(1, from);
        map.weight[i] = scalarList(1, scalar(1));
    };
    setSize(m.nodes, now.nNodes());
    setSize(m.vertices, now.nVertices());
    setSize(m.cells, now.mesh().nCells());

    const labelList kept(keptNodes(old, now));
    m.displacement = vectorField(now.nNodes(), Zero);
    forAll(kept, n)
    {
        if (kept[n] >= 0)
        {
            if (n >= now.nVertices()) m.displacement[n] = old.x[kept[n]] - now.points()[n];
            keep(m.nodes, n, kept[n]);
            if (n < now.nVertices()) keep(m.vertices, n, kept[n]);
            continue;
        }
        const elementSearch::place place(old.search.find(now.points()[n], tolerance_));
        if (place.block < 0) return outside(now.points()[n], place);
        old.search.weights(place, m.nodes.from[n], m.nodes.weight[n]);
        if (n < now.nVertices()) old.search.vertexWeights(place, m.vertices.from[n], m.vertices.weight[n]);
    }
    forAll(m.cells.from, c) keep(m.cells, c, old.cellMap[c]);
    return "";
}


// ************************************************************************* //

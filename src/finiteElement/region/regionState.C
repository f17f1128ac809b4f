/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "regionState.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

const Foam::valueMap& Foam::stateMap::at(const fieldLayout::support on) const
{
    switch (on)
    {
        case fieldLayout::support::VERTICES: return vertices;
        case fieldLayout::support::NODES:    return nodes;
        default:                             return cells;
    }
}


Foam::scalarList Foam::regionState::copy() const
{
    label n = 0;
    for (const statePart& p : parts_) n += p.nScalars();
    scalarList values(n);
    scalar* to = values.data();
    for (const statePart& p : parts_) to = p.copy(to);
    return values;
}


void Foam::regionState::set(const UList<scalar>& values)
{
    const scalar* from = values.cdata();
    for (statePart& p : parts_) from = p.set(from);
}


// ************************************************************************* //

/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "fieldUnknowns.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fieldUnknowns::fieldUnknowns
(
    const fieldLayout& layout,
    const nodeMap& map,
    const labelUList& node,
    const UList<labelList>& offset
)
:
    layout_(layout),
    map_(map),
    node_(node),
    start_(offset)
{
    forAll(start_, f) forAll(start_[f], i)
    {
        start_[f][i] += map.start(node_[layout.entity(f, i)]);
    }
}


Foam::fieldUnknowns::fieldUnknowns(const fieldLayout& layout, const nodeMap& map)
:
    fieldUnknowns(layout, map, identity(layout.nEntities()), offsets(layout))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::labelList Foam::fieldUnknowns::counts(const fieldLayout& layout)
{
    labelList n(layout.nEntities(), 0);
    for (label f = 0; f < layout.nFields(); ++f)
    {
        for (label i = 0; i < layout.size(f); ++i) n[layout.entity(f, i)] += layout.nComponents(f);
    }
    return n;
}


Foam::List<Foam::labelList> Foam::fieldUnknowns::offsets(const fieldLayout& layout)
{
    labelList n(layout.nEntities(), 0);
    List<labelList> offset(layout.nFields());
    forAll(offset, f)
    {
        offset[f].setSize(layout.size(f));
        forAll(offset[f], i)
        {
            label& at = n[layout.entity(f, i)];
            offset[f][i] = at;
            at += layout.nComponents(f);
        }
    }
    return offset;
}


void Foam::fieldUnknowns::add(const label field, const vectorField& v, scalarField& x) const
{
    forAll(v, i) forCmpts(field, i, [&](const label c, const label u) { x[u] += v[i][c]; });
}


void Foam::fieldUnknowns::add(const label field, const scalarField& s, scalarField& x) const
{
    forAll(s, i) x[start_[field][i]] += s[i];
}


// ************************************************************************* //

/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "fieldLayout.H"
#include "globalIndex.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fieldLayout::fieldLayout(const feMesh& fe, const List<field>& fields)
:
    fe_(fe),
    fields_(fields),
    cells_(false)
{
    for (const field& f : fields_) cells_ = cells_ || f.on == support::CELLS;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::fieldLayout::nComponents(const label f) const
{
    return fields_[f].is == kind::VECTOR ? fe_.dim() : 1;
}


Foam::label Foam::fieldLayout::size(const label f) const
{
    switch (fields_[f].on)
    {
        case support::VERTICES: return fe_.nVertices();
        case support::NODES:    return fe_.nNodes();
        default:                return fe_.mesh().nCells();
    }
}


Foam::label Foam::fieldLayout::entity(const label f, const label value) const
{
    return fields_[f].on == support::CELLS ? fe_.nNodes() + value : value;
}


Foam::label Foam::fieldLayout::value(const label f, const label entity) const
{
    const label i = fields_[f].on == support::CELLS ? entity - fe_.nNodes() : entity;
    return i < size(f) ? max(i, label(-1)) : -1;
}


Foam::labelList Foam::fieldLayout::keys() const
{
    labelList key(fe_.key());
    if (!cells_) return key;

    const label nNodeKeys = returnReduce(fe_.nNodes(), sumOp<label>());
    const globalIndex cells(fe_.mesh().nCells());
    key.setSize(nEntities());
    for (label c = 0; c < fe_.mesh().nCells(); ++c)
    {
        key[fe_.nNodes() + c] = nNodeKeys + cells.toGlobal(c);
    }
    return key;
}


Foam::label Foam::fieldLayout::nKeys() const
{
    return returnReduce(nEntities(), sumOp<label>());
}


Foam::word Foam::fieldLayout::componentName(const label f, const label cmpt) const
{
    const field& at = fields_[f];
    return at.is == kind::VECTOR ? word(at.name + '.' + Foam::name(fe_.axis(cmpt))) : at.name;
}


// ************************************************************************* //

/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "fieldLayout.H"
#include "globalIndex.H"
#include "OStringStream.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fieldLayout::fieldLayout(const feMesh& fe, const List<field>& fields)
:
    fe_(fe),
    fields_(fields),
    cells_(false),
    nBodies_(0)
{
    for (const field& f : fields_)
    {
        cells_ = cells_ || f.on == support::CELLS;
        nBodies_ = max(nBodies_, f.nBodies);
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::label Foam::fieldLayout::first(const label f) const
{
    switch (fields_[f].on)
    {
        case support::CELLS:    return fe_.nNodes();
        case support::BODIES:   return firstBody();
        default:                return 0;
    }
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
        case support::BODIES:   return nBodies_;
        default:                return fe_.mesh().nCells();
    }
}


Foam::label Foam::fieldLayout::value(const label f, const label entity) const
{
    const label i = entity - first(f);
    return i < size(f) ? max(i, label(-1)) : -1;
}


Foam::labelList Foam::fieldLayout::keys() const
{
    labelList key(fe_.key());
    if (!cells_ && !nBodies_) return key;

    const label nNodeKeys = returnReduce(fe_.nNodes(), sumOp<label>());
    const globalIndex cells(fe_.mesh().nCells());
    key.setSize(nEntities());
    for (label e = fe_.nNodes(); e < firstBody(); ++e)
    {
        key[e] = nNodeKeys + cells.toGlobal(e - fe_.nNodes());
    }
    for (label e = firstBody(); e < nEntities(); ++e)
    {
        key[e] = nNodeKeys + cells.size() + e - firstBody();
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


Foam::string Foam::fieldLayout::place(const label f, const label value) const
{
    OStringStream os;
    switch (fields_[f].on)
    {
        case support::CELLS:    os << "at " << fe_.mesh().cellCentres()[value]; break;
        case support::BODIES:   os << "of rigid body " << value; break;
        default:                os << "at " << fe_.points()[value];
    }
    return os.str();
}


// ************************************************************************* //

/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "pressureMacros.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::label Foam::pressureMacros::nShared(const place& a, const place& b) const
{
    const elementBlock &A = fe_.blocks()[a.first()], &B = fe_.blocks()[b.first()];
    const SubList<label> vertices(A.nodes, A.nVertices(), a.second()*A.nNodes);
    label n = 0;
    for (label i = 0; i < B.nVertices(); ++i) n += vertices.found(B.element(b.second())[i]);
    return n;
}


Foam::List<Foam::pressureMacros::follower> Foam::pressureMacros::group
(
    const UList<place>& around
) const
{
    const label dim = fe_.dim(), ofFace = dim == 2 ? 2 : 4;
    const auto cell = [&](const place& p) { return fe_.blocks()[p.first()].cells[p.second()]; };
    DynamicList<place> neighbours;
    for (label i = 1; i < around.size(); ++i)
    {
        if (nShared(around[0], around[i]) == ofFace) neighbours.append(around[i]);
    }
    if (neighbours.size() != dim) return List<follower>();

    DynamicList<follower> all;
    label nOpposite = 0;
    for (label i = 1; i < around.size(); ++i)
    {
        if (neighbours.found(around[i])) continue;
        const bool opposite = nShared(around[0], around[i]) == 1;
        nOpposite += opposite;
        labelList beside;
        for (const place& k : neighbours)
        {
            if (opposite || nShared(k, around[i]) == ofFace) beside.append(cell(k));
        }
        if (beside.size() != (opposite ? dim : 2)) return List<follower>();
        all.append({cell(around[i]), cell(around[0]), beside});
    }
    return nOpposite == 1 ? List<follower>(all) : List<follower>();
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::pressureMacros::pressureMacros(const feMesh& fe)
:
    fe_(fe),
    follows_(fe.mesh().nCells(), false)
{
    List<DynamicList<place>> around(fe.nNodes());
    forAll(fe.blocks(), b)
    {
        const elementBlock& block = fe.blocks()[b];
        for (label e = 0; e < block.size(); ++e) for (label i = 0; i < block.nVertices(); ++i)
        {
            around[block.element(e)[i]].append(place(b, e));
        }
    }
    boolList inside(fe.nNodes(), true), used(fe.mesh().nCells(), false);
    for (const polyPatch& pp : fe.mesh().boundaryMesh())
    {
        if (fe.dim() == 2 && pp.type() == "empty") continue;
        for (const label p : pp.meshPoints()) inside[fe.pointNode()[p]] = false;
    }
    forAll(around, n)
    {
        if (!inside[n] || around[n].size() != (fe.dim() == 2 ? 4 : 8)) continue;
        const auto cell = [&](const place& p) { return fe.blocks()[p.first()].cells[p.second()]; };
        bool free = true;
        for (const place& p : around[n]) free = free && !used[cell(p)];
        const List<follower> found(free ? group(around[n]) : List<follower>());
        if (found.empty()) continue;
        for (const place& p : around[n]) used[cell(p)] = true;
        for (const follower& f : found) follows_[f.cell] = true;
        followers_.append(found);
        ++nGroups_;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::pressureMacros::nGroups() const
{
    return returnReduce(nGroups_, sumOp<label>());
}


void Foam::pressureMacros::tie
(
    const fieldUnknowns& unknowns,
    const label field,
    dofConstraints& c
) const
{
    typedef dofConstraints::term term;
    for (const follower& f : followers_)
    {
        List<term> row;
        for (const label k : f.neighbours) row.append(term(unknowns.start(field, k), 1));
        row.append(term(unknowns.start(field, f.first), 1 - f.neighbours.size()));
        c.tie(unknowns.start(field, f.cell), row);
    }
}


void Foam::pressureMacros::project(scalarField& p) const
{
    for (const follower& f : followers_)
    {
        p[f.cell] = (1 - f.neighbours.size())*p[f.first];
        for (const label k : f.neighbours) p[f.cell] += p[k];
    }
}


// ************************************************************************* //

/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "remeshSelection.H"
#include "pinchedPoints.H"
#include "unknownEntries.H"
#include "PstreamReduceOps.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

static bool allOf(const dictionary& dict)
{
    const wordList valid({"all", "bad"});
    const word extent(dict.getOrDefault<word>("extent", valid[0]));
    if (!valid.found(extent))
    {
        FatalIOErrorInFunction(dict)
            << "Unknown extent " << extent << ". Valid: " << valid << exit(FatalIOError);
    }
    return extent == valid[0];
}


static labelList trues(const boolList& in)
{
    DynamicList<label> list;
    forAll(in, i) if (in[i]) list.append(i);
    return labelList(list);
}


//- Call f(cell, vertices) for all elements
template<class F>
static void forElements(const feMesh& fe, const F& f)
{
    for (const elementBlock& block : fe.blocks()) for (label e = 0; e < block.size(); ++e)
    {
        f(block.cells[e], SubList<label>(block.nodes, block.nVertices(), e*block.nNodes));
    }
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::boolList Foam::remeshSelection::cellsOf(const polyMesh& mesh, const wordRes& zones) const
{
    boolList in(mesh.nCells(), false);
    for (const wordRe& zone : zones)
    {
        const labelList indices(mesh.cellZones().indices(zone));
        if (indices.empty())
        {
            FatalIOErrorInFunction(dict_)
                << "Region " << mesh.name() << " has no cellZone '" << zone.c_str()
                << "'. Its cellZones are " << mesh.cellZones().names() << exit(FatalIOError);
        }
        for (const label i : indices) for (const label c : mesh.cellZones()[i]) in[c] = true;
    }
    return in;
}


Foam::boolList Foam::remeshSelection::eligible(const polyMesh& mesh) const
{
    boolList may(zones_.empty() ? boolList(mesh.nCells(), true) : cellsOf(mesh, zones_));
    const boolList mayNot(cellsOf(mesh, excluded_));
    forAll(may, c) may[c] = may[c] && !mayNot[c];
    return may;
}


void Foam::remeshSelection::addLayer(const feMesh& fe, const boolList& may, boolList& in) const
{
    boolList at(fe.nNodes(), false);
    forElements(fe, [&](const label c, const labelUList& nodes) { if (in[c]) for (const label n : nodes) at[n] = true; });
    forElements(fe, [&](const label c, const labelUList& nodes) { if (may[c]) for (const label n : nodes) if (at[n]) in[c] = true; });
}


void Foam::remeshSelection::unpinch(const feMesh& fe, const boolList& may, boolList& in) const
{
    for (label nBefore = -1, n = 0; n != nBefore;)
    {
        nBefore = n;
        labelList nodes;
        boolList at(fe.nNodes(), false);
        for (const label p : pinchedPoints(simplicesOf(fe, fe.points(), trues(in), nodes))) at[nodes[p]] = true;
        forElements(fe, [&](const label c, const labelUList& nodes)
        {
            if (in[c] || !may[c]) return;
            for (const label node : nodes) in[c] = in[c] || at[node];
            n += in[c];
        });
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::remeshSelection::remeshSelection(const dictionary& dict)
:
    dict_(dict),
    zones_(dict.getOrDefault<wordRes>("cellZones", wordRes())),
    excluded_(dict.getOrDefault<wordRes>("excludedZones", wordRes())),
    all_(allOf(dict)),
    nLayers_(dict.getOrDefault<label>("layers", 2))
{
    reportUnknownEntries(dict, {"cellZones", "excludedZones", "extent", "layers"});
    if (nLayers_ < 0)
    {
        FatalIOErrorInFunction(dict)
            << "layers is " << nLayers_ << ", expected 0 or more" << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::remeshSelection::check(const feMesh& fe) const
{
    const boolList may(eligible(fe.mesh()));
    label n = 0, nAll = 0;
    point where = point::max;
    for (const elementBlock& block : fe.blocks())
    {
        const bool simplex = block.shape == elementShape::TRI || block.shape == elementShape::TET;
        for (const label c : block.cells)
        {
            if (!may[c]) continue;
            ++nAll;
            if (simplex) continue;
            ++n;
            where = min(where, fe.mesh().cellCentres()[c]);
        }
    }
    reduce(n, sumOp<label>());
    reduce(nAll, sumOp<label>());
    reduce(where, minOp<point>());
    if (n)
    {
        FatalIOErrorInFunction(dict_)
            << "Region " << fe.mesh().name() << ": " << n << " of the " << nAll
            << " cells that may be exchanged are no " << (fe.dim() == 2 ? "triangles" : "tetrahedra")
            << ", at " << where << " and beyond." << nl
            << "Put them into a cellZone of excludedZones, or name the others in cellZones"
            << exit(FatalIOError);
    }
    if (!nAll)
    {
        FatalIOErrorInFunction(dict_)
            << "Region " << fe.mesh().name() << " has no cells that may be exchanged"
            << exit(FatalIOError);
    }
}


Foam::labelList Foam::remeshSelection::cells(const feMesh& fe, const labelHashSet& bad) const
{
    const polyMesh& mesh = fe.mesh();
    const boolList may(eligible(mesh));
    boolList in(mesh.nCells(), false);
    if (all_) in = may;
    else
    {
        for (const label c : bad) in[c] = may[c];
        for (label layer = 0; layer < nLayers_; ++layer) addLayer(fe, may, in);
    }
    if (fe.dim() == 3) unpinch(fe, may, in);
    return trues(in);
}


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::simplexMesh Foam::simplicesOf
(
    const feMesh& fe,
    const vectorField& x,
    const labelUList& cells,
    labelList& nodes
)
{
    // Cells of the same zones are a domain
    const polyMesh& mesh = fe.mesh();
    labelListList zonesOf(mesh.nCells());
    for (const cellZone& zone : mesh.cellZones()) for (const label c : zone) zonesOf[c].append(zone.index());
    HashTable<label, labelList, Hash<labelList>> domainOf;
    boolList in(mesh.nCells(), false);
    for (const label c : cells) in[c] = true;

    simplexMesh s;
    s.dim = fe.dim();
    labelList number(fe.nNodes(), -1);
    DynamicList<label> used, domains;
    DynamicList<point> points;
    DynamicList<labelList> simplices;
    for (const elementBlock& block : fe.blocks()) for (label e = 0; e < block.size(); ++e)
    {
        const label celli = block.cells[e];
        if (!in[celli]) continue;
        labelList v(fe.dim() + 1);
        forAll(v, i)
        {
            const label n = block.element(e)[i];
            if (number[n] < 0)
            {
                number[n] = used.size();
                used.append(n);
                point p = Zero;
                for (label a = 0; a < fe.dim(); ++a) p[a] = x[n][fe.axis(a)];
                points.append(p);
            }
            v[i] = number[n];
        }
        simplices.append(v);
        domains.append(domainOf.lookup(zonesOf[celli], -1));
        if (domains.last() >= 0) continue;
        domains.last() = domainOf.size();
        domainOf.insert(zonesOf[celli], domains.last());
    }
    nodes.transfer(used);
    s.points.transfer(points);
    s.cells.transfer(simplices);
    s.domains.transfer(domains);
    s.origin = identity(s.points.size());
    return s;
}


// ************************************************************************* //

/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "solidAssembly.H"
#include "feValues.H"
#include "unknownEntries.H"
#include "symmTensorField.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- The list must be that of names, each with a dictionary
static void checkMaterials(const dictionary& dict)
{
    const entry& e = dict.lookupEntry("materials", keyType::REGEX);
    bool good = e.isStream(), named = false;
    label depth = 0;
    if (good) for (const token& t : e.stream())
    {
        const bool opens = t == token::BEGIN_LIST || t == token::BEGIN_BLOCK;
        const bool closes = t == token::END_LIST || t == token::END_BLOCK;
        if (depth == 0) good = good && (t == token::BEGIN_LIST || t.isLabel());
        if (depth == 1) good = good && (closes ? !named : named ? t == token::BEGIN_BLOCK : t.isWord());
        if (depth == 1) named = t.isWord();
        depth += label(opens) - label(closes);
    }
    if (good) return;
    FatalIOErrorInFunction(dict)
        << "Entry materials is no list of materials, expected"
        << " materials ( <name> { type ...; rho ...; ... } ... );"
        << exit(FatalIOError);
}


//- Give a dictionary made from a list its place for messages
static void setName(dictionary& dict, const fileName& name)
{
    dict.name() = name;
    for (entry& e : dict)
    {
        const fileName entryName(name + '.' + e.keyword());
        if (e.isDict()) setName(e.dict(), entryName);
        else e.name() = entryName;
    }
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::solidAssembly::addCells
(
    const dictionary& dict,
    const label materiali,
    labelList& cellMaterial
) const
{
    const polyMesh& mesh = fe_.mesh();
    labelList cells;
    if (dict.found("cellZone"))
    {
        const word zone(dict.get<word>("cellZone"));
        const label zonei = mesh.cellZones().findZoneID(zone);
        if (zonei < 0)
        {
            FatalIOErrorInFunction(dict)
                << "Region " << mesh.name() << " has no cellZone '" << zone
                << "'. Its cellZones are " << mesh.cellZones().names()
                << exit(FatalIOError);
        }
        cells = mesh.cellZones()[zonei];
    }
    else
    {
        cells = identity(mesh.nCells());
    }

    for (const label celli : cells)
    {
        if (cellMaterial[celli] >= 0)
        {
            FatalIOErrorInFunction(dict)
                << "Cell " << celli << " at " << mesh.cellCentres()[celli]
                << " has the materials '" << names_[cellMaterial[celli]]
                << "' and '" << names_[materiali] << "', expected one." << nl
                << "Without the entry cellZone a material is that of all cells"
                << exit(FatalIOError);
        }
        cellMaterial[celli] = materiali;
    }
}


Foam::labelList Foam::solidAssembly::readMaterials(const dictionary& dict)
{
    reportUnknownEntries(dict, {"materials"});
    checkMaterials(dict);
    const PtrList<entry> entries(dict.lookup("materials"));
    materials_.setSize(entries.size());
    names_.setSize(entries.size());
    labelList cellMaterial(fe_.mesh().nCells(), -1);

    forAll(entries, i)
    {
        names_[i] = entries[i].keyword();
        dictionary material(entries[i].dict());
        setName(material, dict.name() + ".materials." + names_[i]);
        materials_.set(i, solidMaterial::New(material));
        loops_.append(materials_[i].elementLoop().ptr());
        addCells(material, i, cellMaterial);
    }

    const label celli = cellMaterial.find(-1);
    if (celli >= 0)
    {
        FatalIOErrorInFunction(dict)
            << "Cell " << celli << " at " << fe_.mesh().cellCentres()[celli]
            << " of region " << fe_.mesh().name() << " has no material. The"
            << " materials are " << names_ << exit(FatalIOError);
    }
    return cellMaterial;
}


void Foam::solidAssembly::split(const labelList& cellMaterial)
{
    DynamicList<elementBlock> blocks;
    DynamicList<label> material;

    for (const elementBlock& all : fe_.blocks())
    {
        forAll(materials_, m)
        {
            DynamicList<label> nodes, cells;
            for (label e = 0; e < all.size(); ++e)
            {
                if (cellMaterial[all.cells[e]] != m) continue;
                for (label i = 0; i < all.nNodes; ++i) nodes.append(all.element(e)[i]);
                cells.append(all.cells[e]);
            }
            if (cells.empty()) continue;

            elementBlock block;
            block.shape = all.shape;
            block.order = all.order;
            block.nNodes = all.nNodes;
            block.nodes.transfer(nodes);
            block.cells.transfer(cells);
            block.colour(fe_.nNodes());
            blocks.append(block);
            material.append(m);
        }
    }
    blocks_.transfer(blocks);
    material_.transfer(material);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::solidAssembly::solidAssembly
(
    const feMesh& fe,
    const dictionary& mechanicalProperties
)
:
    fe_(fe)
{
    split(readMaterials(mechanicalProperties));
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::solidAssembly::assemble
(
    const solidStage& stage,
    vectorField& force,
    feMatrix* K,
    const PtrList<elementScatter>& scatter
) const
{
    scalar minDetJ = GREAT;
    forAll(blocks_, b)
    {
        const solidElementLoop& loop = loops_[material_[b]];
        if (K)
        {
            const solidMatrix to{*K, scatter[b]};
            minDetJ = min(minDetJ, loop.assemble(blocks_[b], stage, force, &to));
        }
        else
        {
            minDetJ = min(minDetJ, loop.assemble(blocks_[b], stage, force, nullptr));
        }
    }
    return minDetJ;
}


void Foam::solidAssembly::stress
(
    const vectorField& D,
    symmTensorField& sigma
) const
{
    forAll(blocks_, b)
    {
        const elementBlock& block = blocks_[b];
        withElement(block, [&](auto tag)
        {
            typedef decltype(tag) E;
            double centre[E::dim] = {}, N[E::nNodes], dN[E::nNodes][E::dim];
            for (int i = 0; i < E::nVertices; ++i) for (int c = 0; c < E::dim; ++c)
            {
                centre[c] += E::xi[i][c]/E::nVertices;
            }
            E::shape(centre, N, dN);

            for (label e = 0; e < block.size(); ++e)
            {
                // d X/d xi and d D/d xi; with the unit tensor out of plane
                typedef Ten<double, 3> ten;
                ten dX = ten::zero(), dD = ten::zero();
                for (int c = E::dim; c < 3; ++c) dX(fe_.axis(c), c) = 1;
                for (int i = 0; i < E::nNodes; ++i)
                {
                    const label n = block.element(e)[i];
                    for (int a = 0; a < E::dim; ++a) for (int c = 0; c < E::dim; ++c)
                    {
                        const label k = fe_.axis(a);
                        dX(k, c) += fe_.points()[n][k]*dN[i][c];
                        dD(k, c) += D[n][k]*dN[i][c];
                    }
                }
                const ten F = (dD & inv(dX)).addDiag(1);

                // sigma = P F^T/J
                const ten s = (1/det(F))*(material(b).P(F) & F.t());
                sigma[block.cells[e]] =
                    symmTensor(s(0, 0), s(0, 1), s(0, 2), s(1, 1), s(1, 2), s(2, 2));
            }
        });
    }
}


// ************************************************************************* //

/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "solidAssembly.H"
#include "shellLoop.H"
#include "unknownEntries.H"
#include <memory>

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
    loops_.setSize(entries.size());
    mixedLoops_.setSize(entries.size());
    viscosity_.setSize(entries.size());
    labelList cellMaterial(fe_.mesh().nCells(), -1);

    forAll(entries, i)
    {
        names_[i] = entries[i].keyword();
        dictionary material(entries[i].dict());
        setName(material, dict.name() + ".materials." + names_[i]);
        addMaterial(material, i);
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


void Foam::solidAssembly::addMaterial(const dictionary& dict, const label materiali)
{
    materials_.set(materiali, solidMaterial::New(dict));
    solidMaterial& material = materials_[materiali];
    material.setAxes({fe_.axis(0), fe_.axis(1), fe_.axis(2)});
    viscosity_.set(materiali, new solidViscosity(dict));
    if ((elements_.enhanced || elements_.shell) && !viscosity_[materiali].empty())
    {
        FatalIOErrorInFunction(dict)
            << "Material '" << names_[materiali] << "' has Prony or damping, which elements "
            << elements_.name << " have not." << nl
            << "Choose other elements in feSchemes, as quadratic or Q1Q0" << exit(FatalIOError);
    }

    const mixedMaterial* mixed = dynamic_cast<const mixedMaterial*>(&material);
    if (mixed && elements_.mixed)
    {
        mixedLoops_.set(materiali, mixed->mixedLoop());
        return;
    }
    if (mixed && mixed->rKappa() == 0)
    {
        FatalIOErrorInFunction(dict)
            << "Material '" << names_[materiali] << "' has no bulkModulus, so it is"
            << " incompressible, which elements " << elements_.name << " cannot be." << nl
            << "Choose elements Q1Q0, equalOrder or taylorHood in feSchemes, or give a"
            << " bulkModulus" << exit(FatalIOError);
    }
    if (elements_.shell && !shellLoop::suits(material))
    {
        FatalIOErrorInFunction(dict)
            << "Material '" << names_[materiali] << "' sees rotations, which elements "
            << elements_.name << " cannot have." << nl
            << "Choose StVenantKirchhoff in place of linearElastic, or other elements"
            << exit(FatalIOError);
    }
    if (elements_.shell) loops_.set(materiali, new shellLoop(material));
    else loops_.set(materiali, material.elementLoop());
}


void Foam::solidAssembly::checkShapes() const
{
    const bool onCells = elements_.pressureOn == fieldLayout::support::CELLS;
    forAll(blocks_, b)
    {
        const elementShape shape = blocks_[b].shape;
        const bool isHex = shape == elementShape::HEX;
        if (elements_.shell ? isHex : !onCells || !mixed(b) || isHex || shape == elementShape::QUAD) continue;
        FatalErrorInFunction
            << "Cell " << blocks_[b].cells[0] << " of region " << fe_.mesh().name() << " at "
            << fe_.mesh().cellCentres()[blocks_[b].cells[0]] << " is a " << elementName(shape)
            << "; elements " << elements_.name << " are "
            << (elements_.shell ? "" : "quadrilaterals and ") << "hexahedra." << nl
            << "For other shapes choose "
            << (elements_.shell ? "enhancedStrain or quadratic" : "equalOrder or taylorHood")
            << exit(FatalError);
    }
}


Foam::tmp<Foam::scalarField> Foam::solidAssembly::vertexPressure
(
    const scalarField& p,
    const label materiali
) const
{
    tmp<scalarField> tmean(new scalarField(fe_.nNodes(), Zero));
    scalarField &sum = tmean.ref(), volume(sum);
    forAll(blocks_, b)
    {
        const elementBlock& block = blocks_[b];
        if (material_[b] != materiali) continue;
        for (label e = 0; e < block.size(); ++e) for (label i = 0; i < block.nVertices(); ++i)
        {
            const scalar V = fe_.mesh().cellVolumes()[block.cells[e]];
            sum[block.element(e)[i]] += V*p[block.cells[e]];
            volume[block.element(e)[i]] += V;
        }
    }
    if (Pstream::parRun())
    {
        fe_.copies().sum(sum);
        fe_.copies().sum(volume);
    }
    sum /= max(volume, VSMALL);
    return tmean;
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
            if (elements_.shell && block.shape == elementShape::HEX) shellLoop::thicknessLast(fe_.points(), block);
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
    const solidElements& elements,
    const dictionary& mechanicalProperties
)
:
    fe_(fe),
    elements_(elements)
{
    split(readMaterials(mechanicalProperties));
    checkShapes();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::labelHashSet Foam::solidAssembly::withoutPressure() const
{
    labelHashSet found;
    forAll(blocks_, b)
    {
        const elementBlock& block = blocks_[b];
        if (mixed(b)) continue;
        if (elements_.pressureOn == fieldLayout::support::CELLS) found.insert(block.cells);
        else for (label e = 0; e < block.size(); ++e)
        {
            for (label i = 0; i < block.nVertices(); ++i) found.insert(block.element(e)[i]);
        }
    }
    return found;
}


Foam::tmp<Foam::scalarField> Foam::solidAssembly::cellPressure(const scalarField& p) const
{
    const bool onCells = elements_.pressureOn == fieldLayout::support::CELLS;
    tmp<scalarField> tcells(new scalarField(fe_.mesh().nCells(), Zero));
    scalarField& cells = tcells.ref();
    forAll(materials_, m)
    {
        if (!mixedLoops_.set(m)) continue;
        const scalarField atVertices(onCells ? vertexPressure(p, m) : tmp<scalarField>(p));
        forAll(blocks_, b)
        {
            const elementBlock& block = blocks_[b];
            const label n = block.nVertices();
            if (material_[b] != m) continue;
            for (label e = 0; e < block.size(); ++e) for (label i = 0; i < n; ++i)
            {
                cells[block.cells[e]] += atVertices[block.element(e)[i]]/n;
            }
        }
    }
    return tcells;
}


Foam::scalar Foam::solidAssembly::assemble
(
    const mixedStage& stage,
    vectorField& force,
    scalarField& volume,
    feMatrix* K,
    const PtrList<elementScatter>& scatter
) const
{
    scalar minDetJ = GREAT;
    forAll(blocks_, b)
    {
        std::unique_ptr<solidMatrix> to;
        if (K) to.reset(new solidMatrix{*K, scatter[b]});
        const label m = material_[b];
        const scalar detJ =
            mixed(b)
          ? mixedLoops_[m].assemble(blocks_[b], stage, force, volume, to.get())
          : loops_[m].assemble(blocks_[b], stage, force, to.get());
        if (prestress_) prestress_->assemble(blocks_[b], stage, force, to.get());
        minDetJ = min(minDetJ, detJ);
    }
    return minDetJ;
}


void Foam::solidAssembly::setPrestress(autoPtr<solidPrestress> prestress)
{
    if (prestress && (elements_.enhanced || elements_.shell))
    {
        FatalErrorInFunction
            << "Region " << fe_.mesh().name() << " has a field prestress, which elements "
            << elements_.name << " have not." << nl
            << "Choose other elements in feSchemes, as quadratic or Q1Q0, or remove the field"
            << exit(FatalError);
    }
    prestress_ = std::move(prestress);
}


// ************************************************************************* //

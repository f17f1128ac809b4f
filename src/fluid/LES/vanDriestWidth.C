/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "vanDriestWidth.H"
#include "patchDataWave.H"
#include "readNumber.H"
#include "subDictOrEmpty.H"
#include "unknownEntries.H"
#include "wallPointData.H"
#include "wallPolyPatch.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalarField Foam::vanDriestWidth::viscousLength
(
    const label patchi,
    const feMesh& fe,
    const vectorField& v,
    const vectorField& vCells,
    const scalar nu
) const
{
    const fvPatch& wall = mesh_.boundary()[patchi];
    const vectorField n(wall.nf()), toWall(wall.Cf() - wall.Cn());
    const labelUList& cells = wall.faceCells();
    scalarField length(wall.size());
    for (const elementBlock& faces : fe.patchBlocks(patchi)) for (label e = 0; e < faces.size(); ++e)
    {
        const label f = faces.cells[e];
        vector slip(vCells[cells[f]]);
        for (label i = 0; i < faces.nNodes; ++i) slip -= v[faces.element(e)[i]]/faces.nNodes;
        const scalar shear = mag(slip - (slip & n[f])*n[f])/(toWall[f] & n[f]);
        length[f] = nu/::sqrt(nu*shear + VSMALL);
    }
    return length;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::vanDriestWidth::vanDriestWidth(const fvMesh& mesh, const dictionary& les)
:
    mesh_(mesh)
{
    const dictionary coeffs(subDictOrEmpty(les, "vanDriestCoeffs"));
    reportUnknownEntries(coeffs, {"delta", "cubeRootVolCoeffs", "Aplus", "Cdelta", "calcInterval"});
    if (coeffs.lookupOrDefault<label>("calcInterval", 1) != 1)
    {
        FatalIOErrorInFunction(coeffs)
            << "calcInterval is " << coeffs.get<label>("calcInterval")
            << ", expected 1: the width of the filter is new at each step" << exit(FatalIOError);
    }
    const auto read = [](const dictionary& dict, const word& name, const scalar byDefault)
    {
        return dict.found(name) ? readNumber(dict, name, dimless, 0, GREAT) : byDefault;
    };
    Aplus_ = read(coeffs, "Aplus", 26);
    slope_ = read(les, "kappa", 0.41)/read(coeffs, "Cdelta", 0.158);
    if (mesh.boundaryMesh().findPatchIDs<wallPolyPatch>().empty())
    {
        FatalIOErrorInFunction(les)
            << "delta vanDriest, but no patch of region " << mesh.name() << " is of type wall: "
            << mesh.boundaryMesh().names() << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::vanDriestWidth::update(const feMesh& fe, const vectorField& v, const scalar nu)
{
    vectorField vCells(mesh_.nCells(), Zero);
    for (const elementBlock& block : fe.blocks()) for (label e = 0; e < block.size(); ++e)
    {
        for (label i = 0; i < block.nNodes; ++i) vCells[block.cells[e]] += v[block.element(e)[i]]/block.nNodes;
    }

    const labelHashSet walls(mesh_.boundaryMesh().findPatchIDs<wallPolyPatch>());
    PtrList<scalarField> lengths(mesh_.boundaryMesh().size());
    UPtrList<scalarField> given(lengths.size());
    forAll(lengths, patchi)
    {
        lengths.set
        (
            patchi,
            walls.found(patchi)
          ? new scalarField(viscousLength(patchi, fe, v, vCells, nu))
          : new scalarField(mesh_.boundaryMesh()[patchi].size(), GREAT)
        );
        given.set(patchi, &lengths[patchi]);
    }
    const patchDataWave<wallPointData<scalar>> nearest(mesh_, walls, given, true);

    widest2_.setSize(mesh_.nCells());
    forAll(widest2_, c)
    {
        const scalar y = nearest.distance()[c];
        widest2_[c] = sqr(slope_*y*(1 - ::exp(-y/(Aplus_*nearest.cellData()[c]))));
    }
}


// ************************************************************************* //

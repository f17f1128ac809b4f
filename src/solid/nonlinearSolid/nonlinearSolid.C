/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "nonlinearSolid.H"
#include "zeroGradientFvPatchFields.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(nonlinearSolid, 0);
    addToRunTimeSelectionTable(feRegion, nonlinearSolid, mesh);
}

const Foam::Enum<Foam::nonlinearSolid::elementKind>
Foam::nonlinearSolid::elementKindNames
({
    {elementKind::LINEAR, "linear"},
    {elementKind::ENHANCED_STRAIN, "enhancedStrain"},
    {elementKind::QUADRATIC, "quadratic"},
});


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

static IOobject outputField(const word& name, const fvMesh& mesh)
{
    return IOobject
    (
        name, mesh.time().timeName(), mesh, IOobject::NO_READ, IOobject::AUTO_WRITE
    );
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::nonlinearSolid::elementKind Foam::nonlinearSolid::kind(const dictionary& schemes)
{
    return elementKindNames.get("elements", schemes);
}


void Foam::nonlinearSolid::stage()
{
    const feTimeScheme& ts = timeScheme();
    motion_.stage(ts, stage_.D, stageVelocity_, stage_.a);
    stage_.dDdu = ts.displacementByUnknown();
    stage_.dadu = ts.accelerationByUnknown();
}


Foam::scalar Foam::nonlinearSolid::stageTime() const
{
    const feTimeScheme& ts = timeScheme();
    return mesh_.time().value() - (1 - ts.stage())*ts.deltaT();
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::nonlinearSolid::nonlinearSolid(fvMesh& mesh)
:
    feRegion(mesh, kind(readSchemes(mesh)) == elementKind::QUADRATIC ? 2 : 1),
    assembly_
    (
        fe(),
        IOdictionary(dictObject("mechanicalProperties", mesh.time().constant(), mesh))
    ),
    pointD_(readPointField<vector>("pointD", mesh, dimLength)),
    D_(outputField("D", mesh), mesh, dimensionedVector(dimLength, Zero)),
    sigma_
    (
        outputField("sigma", mesh), mesh, dimensionedSymmTensor(dimPressure, Zero),
        zeroGradientFvPatchField<symmTensor>::typeName
    ),
    sigmaEq_
    (
        outputField("sigmaEq", mesh), mesh, dimensionedScalar(dimPressure, Zero),
        zeroGradientFvPatchField<scalar>::typeName
    ),
    motion_(fe().nNodes()),
    stage_(fe().points(), {fe().axis(0), fe().axis(1), fe().axis(2)}),
    stageVelocity_(fe().nNodes())
{
    stage_.g = g_.value();
    stage_.enhanced = kind(schemes_) == elementKind::ENHANCED_STRAIN;
    motion_.D = fe().interpolate<vector>(pointD_->primitiveField());
    state_.add("D", motion_);
    state_.store();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::nonlinearSolid::nUnknowns(const label) const
{
    return fe().dim();
}


Foam::word Foam::nonlinearSolid::unknownName(const label c) const
{
    return word("pointD." + Foam::name(c));
}


void Foam::nonlinearSolid::connect
(
    const labelUList& systemNode,
    const nodeMap& map
)
{
    systemNode_ = systemNode;
    map_ = &map;
    scatter_.clear();
    for (const elementBlock& block : assembly_.blocks())
    {
        scatter_.append(new elementScatter(block, systemNode_, systemNode_));
    }
}


void Foam::nonlinearSolid::constrain(dofConstraints& c) const
{
    nodalBoundary(fe()).constrain(pointD_(), systemNode_, *map_, c);
}


void Foam::nonlinearSolid::predict(const scalar time)
{
    const feTimeScheme& ts = timeScheme();
    motion_.predict(ts);
    const auto set = [&](const label n, const vector& value)
    {
        vector D = Zero;
        for (label a = 0; a < fe().dim(); ++a) D[fe().axis(a)] = value[fe().axis(a)];
        motion_.setD(ts, n, D);
    };
    nodalBoundary(fe()).forValues(pointD_(), time, systemNode_, *map_, set);
}


void Foam::nonlinearSolid::assemble(scalarField& R, feMatrix* K)
{
    stage();
    force_ = Zero;
    minDetJ_ = assembly_.assemble(stage_, force_, K, scatter_);

    const solidLoads loads(fe(), systemNode_);
    loads.addSurface(pointD_(), stage_, stageTime(), force_, K);
    if (source) loads.addVolume(source, stageTime(), force_);

    addVector(force_, R);
}


void Foam::nonlinearSolid::update(const scalarField& dx)
{
    const feTimeScheme& ts = timeScheme();
    forAll(motion_.D, n)
    {
        const label start = map_->start(systemNode_[n]);
        vector increment = Zero;
        for (label a = 0; a < fe().dim(); ++a) increment[fe().axis(a)] = dx[start + a];
        motion_.add(ts, n, increment);
    }
}


void Foam::nonlinearSolid::derive()
{
    fe().toPoints<vector>(motion_.D, pointD_->primitiveFieldRef());
    toCells<vector>(motion_.D, D_);

    assembly_.stress(motion_.D, sigma_.primitiveFieldRef());
    sigma_.correctBoundaryConditions();
    const symmTensorField s(dev(sigma_.primitiveField()));
    sigmaEq_.primitiveFieldRef() = sqrt(1.5*magSqr(s));
    sigmaEq_.correctBoundaryConditions();
}


// ************************************************************************* //

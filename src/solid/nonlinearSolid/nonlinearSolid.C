/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "nonlinearSolid.H"
#include "zeroGradientFvPatchFields.H"
#include "addToRunTimeSelectionTable.H"
#include "unknownEntries.H"

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


void Foam::nonlinearSolid::initialise()
{
    motion_ = motionField(fe().nNodes());
    motion_.D = fe().interpolate<vector>(pointD_->primitiveField());
    boundary_->project(motion_.D, mesh_.time().timeOutputValue());

    IOobject io("pointV", mesh_.time().timeName(), mesh_, IOobject::MUST_READ, IOobject::NO_WRITE);
    if (!returnReduce(io.typeHeaderOk<pointVectorField>(), orOp<bool>())) return;
    const autoPtr<pointVectorField> pointV(readPointField<vector>("pointV", mesh_, dimVelocity));
    motion_.v = fe().interpolate<vector>(pointV->primitiveField());
    boundary_->project(motion_.v, mesh_.time().timeOutputValue(), true);
}


void Foam::nonlinearSolid::stage()
{
    const feTimeScheme& ts = timeScheme();
    motion_.stage(ts, stage_->D, stageVelocity_, stage_->a);
    stage_->dDdu = ts.displacementByUnknown();
    stage_->dadu = ts.accelerationByUnknown();
}


Foam::List<Foam::fieldLayout::field> Foam::nonlinearSolid::fields() const
{
    typedef fieldLayout layout;
    return {{"pointD", layout::kind::VECTOR, layout::support::NODES, dimLength}};
}


void Foam::nonlinearSolid::makeFields()
{
    assembly_.reset(new solidAssembly(fe(), mechanicalProperties_));
    boundary_.reset(new nodalBoundary(fe(), pointD_()));
    // Together: some ranks may have no node
    if (returnReduce(motion_.size() != fe().nNodes(), orOp<bool>())) initialise();

    stage_.reset(new solidStage(fe().points(), {fe().axis(0), fe().axis(1), fe().axis(2)}));
    stage_->g = g_.value();
    stage_->enhanced = kind(schemes_) == elementKind::ENHANCED_STRAIN;
    stageVelocity_.setSize(fe().nNodes());
    elementSize_ = fe().meanSize();
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::nonlinearSolid::nonlinearSolid(fvMesh& mesh, const dictionary& linearSolver)
:
    feRegion(mesh, kind(readSchemes(mesh)) == elementKind::QUADRATIC ? 2 : 1),
    mechanicalProperties_(dictObject("mechanicalProperties", mesh.time().constant(), mesh)),
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
    )
{
    reportUnknownEntries(schemes_, {"elements", "timeScheme", "curvedPatches"});
    discretise();
    state_.add("D", fieldLayout::support::NODES, motion_);
    state_.shift();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::nonlinearSolid::constrain(dofConstraints& c) const
{
    boundary_->constrain(unknowns(), 0, c);
}


void Foam::nonlinearSolid::predict(const scalar time)
{
    const feTimeScheme& ts = timeScheme();
    motion_.predict(ts);
    boundary_->forValues(time, [&](const label n, const vector& value)
    {
        vector D = Zero;
        for (label a = 0; a < fe().dim(); ++a) D[fe().axis(a)] = value[fe().axis(a)];
        motion_.setD(ts, n, D);
    });
    vectorField D(motion_.D);
    if (boundary_->project(D, time))
    {
        forAll(D, n) if (D[n] != motion_.D[n]) motion_.setD(ts, n, D[n]);
    }
}


void Foam::nonlinearSolid::assemble(scalarField& R, feMatrix* K)
{
    stage();
    force_ = Zero;
    minDetJ_ = assembly_->assemble(stage_(), force_, K, scatter_);

    const solidLoads loads(unknowns());
    loads.addSurface(pointD_(), stage_(), stageTime(), force_, K);
    if (source) loads.addVolume(source, stageTime(), force_);

    unknowns().add(0, force_, R);
}


void Foam::nonlinearSolid::update(const scalarField& dx)
{
    const feTimeScheme& ts = timeScheme();
    forAll(motion_.D, n) motion_.add(ts, n, unknowns().at(0, n, dx));
}


Foam::scalar Foam::nonlinearSolid::unknownScale(const label) const
{
    return elementSize_/timeScheme().displacementByUnknown();
}


Foam::string Foam::nonlinearSolid::singularAdvice(const label) const
{
    return "A displacement is undetermined where nothing holds the solid";
}


void Foam::nonlinearSolid::derive()
{
    fe().toPoints<vector>(motion_.D, pointD_->primitiveFieldRef());
    toCells<vector>(motion_.D, D_);

    assembly_->stress(motion_.D, sigma_.primitiveFieldRef());
    sigma_.correctBoundaryConditions();
    const symmTensorField s(dev(sigma_.primitiveField()));
    sigmaEq_.primitiveFieldRef() = sqrt(1.5*magSqr(s));
    sigmaEq_.correctBoundaryConditions();
}


// ************************************************************************* //

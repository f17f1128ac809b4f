/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "nonlinearSolid.H"
#include "zeroGradientFvPatchFields.H"
#include "addToRunTimeSelectionTable.H"
#include "coastingScheme.H"
#include "unknownEntries.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(nonlinearSolid, 0);
    addToRunTimeSelectionTable(feRegion, nonlinearSolid, mesh);
}


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

//- An error where the motion D of a rigid patch is not what another patch gives at
//  its nodes
static void checkBodies
(
    const feMesh& fe,
    const pointVectorField& pointD,
    const nodalBoundary& boundary,
    const vectorField& D,
    const vectorField& given,
    const scalar tolerance
)
{
    forAll(pointD.boundaryField(), patchi)
    {
        const auto& pf = pointD.boundaryField()[patchi];
        if (!dynamic_cast<const rigidSupport*>(&pf)) continue;
        for (const label n : fe.patchNodes(patchi))
        {
            if (!boundary.constrained(n) || mag(D[n] - given[n]) < tolerance) continue;
            FatalErrorInFunction
                << "rigidPatch " << pf.patch().name() << " of region " << fe.mesh().name()
                << " has a node at " << fe.points()[n] << " that it moves by " << D[n]
                << " at time " << fe.mesh().time().timeName() << ", where patch " << boundary.patchName(n)
                << " wants " << given[n] << exit(FatalError);
        }
    }
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::nonlinearSolid::initialise()
{
    motion_ = motionField(fe().nNodes());
    pressure_ = rateField<scalar>(nPressures());
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
    stage_->p = pressure_.v;
}


Foam::List<Foam::fieldLayout::field> Foam::nonlinearSolid::fields() const
{
    typedef fieldLayout layout;
    List<layout::field> all(elements_.mixed ? 2 : 1);
    all[DISPLACEMENT] = {"pointD", layout::kind::VECTOR, layout::support::NODES, dimLength};
    if (elements_.mixed)
    {
        all[PRESSURE] = {"solidPressure", layout::kind::SCALAR, elements_.pressureOn, dimPressure};
    }
    const label nBodies = rigidBodies::count(pointD_());
    if (nBodies) all.append(rigidBodies::fields(fe(), nBodies));
    return all;
}


void Foam::nonlinearSolid::findHeldPressures()
{
    heldPressures_.clear();
    if (!elements_.mixed) return;
    scalarField nMixed(fe().nNodes(), 0);
    const bool onCells = elements_.pressureOn == fieldLayout::support::CELLS;
    forAll(assembly_->blocks(), b)
    {
        if (onCells || !assembly_->mixed(b)) continue;
        for (const label n : assembly_->blocks()[b].nodes) nMixed[n] = 1;
    }
    if (Pstream::parRun()) fe().copies().sum(nMixed);
    for (const label i : assembly_->withoutPressure().sortedToc())
    {
        if (onCells || nMixed[i] == 0) heldPressures_.append(i);
    }
}


void Foam::nonlinearSolid::makeFields()
{
    assembly_.reset(new solidAssembly(fe(), elements_, mechanicalProperties_));
    assembly_->setPrestress(solidPrestress::New(mesh_));
    assembly_->setSize(history_);
    watch_.reset(new solidWatch(fe(), assembly_()));
    boundary_.reset(new nodalBoundary(fe(), pointD_()));
    bodies_.reset
    (
        new rigidBodies(fe(), pointD_(), boundary_(), elements_.mixed ? 2 : 1, rigidPoints_)
    );
    // Together: some ranks may have no node
    if (returnReduce(motion_.size() != fe().nNodes(), orOp<bool>())) initialise();

    stage_.reset(new mixedStage(fe().points(), {fe().axis(0), fe().axis(1), fe().axis(2)}));
    stage_->g = g_.value();
    stage_->enhanced = elements_.enhanced;
    stage_->pressureOn = elements_.pressureOn;
    stageVelocity_.setSize(fe().nNodes());
    volume_.setSize(nPressures());
    findHeldPressures();
    elementSize_ = fe().meanSize();
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::nonlinearSolid::nonlinearSolid(fvMesh& mesh, const dictionary& linearSolver)
:
    feRegion(mesh, solidElements::select(readSchemes(mesh)).order),
    elements_(solidElements::select(schemes_)),
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
    if (elements_.mixed)
    {
        solidPressure_.reset
        (
            new volScalarField
            (
                outputField("solidPressure", mesh), mesh, dimensionedScalar(dimPressure, Zero),
                zeroGradientFvPatchField<scalar>::typeName
            )
        );
    }
    discretise();
    state_.add("D", fieldLayout::support::NODES, motion_);
    if (elements_.mixed) state_.add("solidPressure", elements_.pressureOn, pressure_);
    if (history_.size()) state_.add("viscous", fieldLayout::support::CELLS, history_);
    if (bodies_->size()) state_.add("rigidPoints", fieldLayout::support::BODIES, rigidPoints_);
    state_.shift();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::nonlinearSolid::constrain(dofConstraints& c) const
{
    boundary_->constrain(unknowns(), DISPLACEMENT, c);
    bodies_->constrain(unknowns(), timeScheme(), c);
    if (!elements_.mixed) return;
    if (elements_.pressureOn == fieldLayout::support::VERTICES)
    {
        boundary_->cyclic().tie(unknowns(), PRESSURE, c);
    }
    for (const label i : heldPressures_) c.fix(unknowns().start(PRESSURE, i));
}


void Foam::nonlinearSolid::predict(const scalar time)
{
    const feTimeScheme& ts = timeScheme();
    motion_.predict(ts);
    pressure_.predictStage(ts);
    if (coastingScheme::on(ts)) return bodies_->predict(ts, time, motion_);

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
    bodies_->predict(ts, time, motion_);
    if (!bodies_->size()) return;
    D = motion_.D;
    if (!boundary_->project(D, time)) return;
    checkBodies(fe(), pointD_(), boundary_(), motion_.D, D, 1e-6*elementSize_);
}


void Foam::nonlinearSolid::addLoads(vectorField& force, feMatrix* K) const
{
    const solidLoads loads(stageLoads());
    const labelList patches(identity(pointD_->boundaryField().size()));
    loads.addSurface(force, K);
    loads.addSupports(patches, stageVelocity_, timeScheme().velocityByUnknown(), force, K);
    if (source) addVolumeLoad(fe(), fe().points(), source, stageTime(), force);
}


void Foam::nonlinearSolid::assemble(scalarField& R, feMatrix* K)
{
    stage();
    force_ = Zero;
    volume_ = 0;
    minDetJ_ = assembly_->assemble(stage_(), force_, volume_, K, scatter_);

    if (assembly_->viscous())
    {
        assembly_->addViscous
        (
            stage_(), timeScheme(), stageVelocity_, motion_.D, history_, force_, K, scatter_
        );
    }

    addLoads(force_, K);

    unknowns().add(DISPLACEMENT, force_, R);
    if (elements_.mixed) unknowns().add(PRESSURE, volume_, R);
}


void Foam::nonlinearSolid::assembleBodies(scalarField& R, feMatrix* K)
{
    bodies_->assemble(timeScheme(), stageTime(), g_.value(), unknowns(), R, K);
}


Foam::List<Foam::rigidMotion> Foam::nonlinearSolid::rigidMotions() const
{
    return bodies_->motions(timeScheme(), g_.value());
}


void Foam::nonlinearSolid::update(const scalarField& dx)
{
    const feTimeScheme& ts = timeScheme();
    forAll(motion_.D, n) motion_.add(ts, n, unknowns().at(DISPLACEMENT, n, dx));
    bodies_->update(ts, unknowns(), dx, motion_);
    forAll(pressure_.v, i)
    {
        pressure_.setStage(ts, i, pressure_.v[i] + dx[unknowns().start(PRESSURE, i)]);
    }
}


void Foam::nonlinearSolid::advance()
{
    assembly_->finish(stage_(), timeScheme(), stageVelocity_, motion_.D, history_);
}


Foam::scalar Foam::nonlinearSolid::residualScale(const label field) const
{
    if (field == DISPLACEMENT) return 0;
    if (field != PRESSURE || !elements_.mixed) return bodies_->residualScale(field);

    // Where a motion passes through nil, that of the step's start counts
    scalar sum = 0;
    forAll(motion_.D, n)
    {
        if (!unknowns().map().owned(unknowns().node(n))) continue;
        sum += max(magSqr(motion_.D[n]), magSqr(motion_.D0[n]));
    }
    return Foam::pow(elementSize_, fe().dim() - 1)*::sqrt(returnReduce(sum, sumOp<scalar>()));
}


Foam::scalar Foam::nonlinearSolid::unknownScale(const label field) const
{
    // Rotations have none
    const scalar size = layout()[field].dimensions == dimLength ? elementSize_ : 1;
    return field == PRESSURE && elements_.mixed ? 0 : size/timeScheme().displacementByUnknown();
}


Foam::string Foam::nonlinearSolid::singularAdvice(const label field) const
{
    if (field == PRESSURE && elements_.mixed)
    {
        return
            "The pressure of an incompressible material is undetermined where its whole"
            " boundary is held: leave a part free, or give a bulkModulus";
    }
    return "A displacement is undetermined where nothing holds the solid";
}


// ************************************************************************* //

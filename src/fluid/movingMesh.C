/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "movingMesh.H"
#include "feRegion.H"
#include "unknownEntries.H"
#include "coastingScheme.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::movingMesh::movingMesh(fvMesh& mesh, const dictionary& linearSolver)
:
    mesh_(mesh),
    dict_
    (
        IOobject
        (
            "dynamicMeshDict", mesh.time().constant(), mesh,
            IOobject::READ_IF_PRESENT, IOobject::NO_WRITE, false
        )
    ),
    linearSolver_(linearSolver),
    fe_(nullptr),
    reference_(D_),
    extended_(true)
{
    if (!moving()) return;
    const word type(meshMotion::select(dict_));
    reportUnknownEntries
    (
        dict_,
        {"motionSolver", type + "Coeffs", "motionSolverLibs", "dynamicFvMesh", "solver"}
    );

    IOobject io
    (
        "pointDisplacement", mesh_.time().timeName(), mesh_,
        IOobject::MUST_READ, IOobject::AUTO_WRITE
    );
    if (returnReduce(io.typeHeaderOk<pointVectorField>(), orOp<bool>()))
    {
        pointDisplacement_ =
            feRegion::readPointField<vector>("pointDisplacement", mesh_, dimLength);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::movingMesh::setFollowing(const labelUList& patches)
{
    if (!moving())
    {
        FatalErrorInFunction
            << "Region " << mesh_.name() << " shares an interface with a solid, but"
            << " its mesh cannot move." << nl
            << "Give " << mesh_.time().constant()/mesh_.name()/"dynamicMeshDict"
            << " with motionSolver feLaplacian;" << exit(FatalError);
    }
    followingPatches_ = patches;
    labelHashSet nodes;
    for (const label patchi : patches) nodes.insert(fe_->patchNodes(patchi));
    following_ = nodes.sortedToc();
}


bool Foam::movingMesh::gives(const label patchi) const
{
    return
        pointDisplacement_.valid()
     && isA<valuePointPatchField<vector>>(pointDisplacement_->boundaryField()[patchi]);
}


void Foam::movingMesh::discretise(const feMesh& fe)
{
    fe_ = &fe;
    motion_.clear();
    S_.clear();
    scatter_.clear();
    position_.clear();
    columns_.clear();
    positions_.clear();
    boundary_.clear();
    const bool first = returnReduce(D_.size() != fe.nNodes(), orOp<bool>());
    if (first) D_ = motionField(fe.nNodes());
    if (!followingPatches_.empty()) setFollowing(labelList(followingPatches_));
    if (!pointDisplacement_.valid()) return;

    reference_.setSize(fe.nNodes());
    boundary_.reset(new nodalBoundary(fe, pointDisplacement_()));
    boundary_->setReference(reference_.now);
    if (first)
    {
        D_.D = fe.interpolate<vector>(pointDisplacement_->primitiveField());
        boundary_->project(D_.D, mesh_.time().timeOutputValue());
    }
}


void Foam::movingMesh::connect
(
    const fieldUnknowns& flow,
    const List<elementBlock>& blocks
)
{
    // Without either the mesh has no reason to move
    if (following_.empty() && followingPatches_.empty() && !pointDisplacement_.valid()) return;

    if (!motion_.valid())
    {
        motion_ = meshMotion::New
        (
            *fe_, pointDisplacement_.get(), followingPatches_, dict_, linearSolver_
        );
    }

    // What is prescribed has no tangent
    if (followingPatches_.empty()) return;

    positions_.reset
    (
        new fieldLayout
        (
            *fe_,
            {{
                "meshPosition", fieldLayout::kind::VECTOR,
                fieldLayout::support::NODES, dimLength
            }}
        )
    );
    columns_.reset(new nodeMap(positions_->keys(), fieldUnknowns::counts(positions_())));
    position_.reset(new fieldUnknowns(positions_(), columns_()));
    scatter_.clear();
    for (const elementBlock& block : blocks)
    {
        scatter_.append(new elementScatter(block, flow, position_()));
    }
    S_.reset(new feMatrix(flow.map(), columns_(), nullptr, scatter_));
    increment_.setSize(fe_->nNodes());
    x_.setSize(columns_->nUnknowns());
    y_.setSize(flow.map().nUnknowns());
}


void Foam::movingMesh::predict(const feTimeScheme& ts, const scalar time)
{
    // What slides along curved surfaces goes by the field's last displacement
    derive();
    if (motion_.valid()) motion_->adapt(D_.D);
    D_.predict(ts);
    if (!pointDisplacement_.valid()) return;
    if (coastingScheme::on(ts))
    {
        if (followingPatches_.empty()) extend(ts);
        return;
    }
    boundary_->forValues
    (
        time,
        [&](const label n, const vector& d) { D_.setD(ts, n, d - reference_.now[n]); }
    );
    const vectorField before(D_.D + reference_.now);
    vectorField D(before);
    if (boundary_->project(D, time))
    {
        forAll(D, n) if (D[n] != before[n]) D_.setD(ts, n, D[n] - reference_.now[n]);
    }
    motion_->renew();
    if (followingPatches_.empty()) extend(ts);
}


void Foam::movingMesh::extend(const feTimeScheme& ts)
{
    if (!motion_.valid()) return;
    vectorField D(D_.D);
    extended_ = motion_->extend(D);
    if (extended_) forAll(D, n) if (!motion_->given(n)) D_.setD(ts, n, D[n]);
}


void Foam::movingMesh::extendRates()
{
    if (!motion_.valid()) return;
    extended_ =
        motion_->extend(D_.D) && motion_->extendIncrement(D_.v) && motion_->extendIncrement(D_.a);
}


void Foam::movingMesh::extendIncrement
(
    const fieldUnknowns& flow,
    const scalarField& dx,
    const scalar factor
)
{
    increment_ = Zero;
    for (const label n : following_) increment_[n] = factor*flow.at(0, n, dx);
    extended_ = motion_->extendIncrement(increment_) && extended_;
}


void Foam::movingMesh::addTangent(scalarField& y)
{
    x_ = 0;
    position_->add(0, increment_, x_);
    S_->multiply(x_, y_);
    y += y_;
}


void Foam::movingMesh::movePoints()
{
    if (moving()) mesh_.movePoints(fe_->movedPoints(D_.D));
}


void Foam::movingMesh::derive()
{
    if (!pointDisplacement_.valid()) return;
    fe_->toPoints<vector>(D_.D, pointDisplacement_->primitiveFieldRef());
}


// ************************************************************************* //

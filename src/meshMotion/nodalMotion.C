/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "nodalMotion.H"
#include "fixedValuePointPatchFields.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

static bool readIncremental(const dictionary& dict)
{
    static const Enum<label> configurations({{0, "total"}, {1, "incremental"}});
    return configurations.getOrDefault("configuration", dict, 0) == 1;
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::nodalMotion::makeBoundary(pointVectorField*& boundary)
{
    if (!boundary)
    {
        const polyBoundaryMesh& patches = fe_.mesh().boundaryMesh();
        wordList types(patches.size(), "fixedValue");
        forAll(patches, p)
        {
            if (polyPatch::constraintType(patches[p].type())) types[p] = patches[p].type();
        }
        byDefault_.reset
        (
            new pointVectorField
            (
                IOobject("meshDisplacement", fe_.mesh().time().timeName(), fe_.mesh()),
                pointMesh::New(fe_.mesh()),
                dimensionedVector(dimLength, Zero),
                types
            )
        );
        boundary = byDefault_.get();
    }
    boundary_.reset(new nodalBoundary(fe_, *boundary));
}


Foam::motionWalls Foam::nodalMotion::walls(const pointVectorField& boundary) const
{
    labelHashSet moving, resting;
    forAll(boundary.boundaryField(), patchi)
    {
        const auto& pf = boundary.boundaryField()[patchi];
        if (!isA<valuePointPatchField<vector>>(pf)) continue;
        const bool rests =
            typeid(pf) == typeid(fixedValuePointPatchField<vector>)
         && gMax(mag(refCast<const valuePointPatchField<vector>>(pf))) < VSMALL;
        (rests ? resting : moving).insert(fe_.patchNodes(patchi));
    }
    for (const label patchi : heldPatches_) moving.insert(fe_.patchNodes(patchi));
    resting -= moving;
    return {moving.sortedToc(), resting.sortedToc(), solverDict_};
}


void Foam::nodalMotion::number(const fieldLayout::kind kind)
{
    layout_.reset
    (
        new fieldLayout
        (
            fe_,
            {{"meshDisplacement", kind, fieldLayout::support::NODES, dimLength}}
        )
    );
    map_.reset(new nodeMap(layout_->keys(), fieldUnknowns::counts(layout_())));
    unknowns_.reset(new fieldUnknowns(layout_(), map_()));
    constraints_.reset(new dofConstraints(map_()));
}


void Foam::nodalMotion::constrain()
{
    constraints_->reopen();
    boundary_->constrain(unknowns_(), 0, constraints_());
    for (const label patchi : heldPatches_) for (const label n : fe_.patchNodes(patchi))
    {
        forCmpts(n, [&](const label, const label, const label u) { constraints_->fix(u); });
    }
    constraints_->close();
}


bool Foam::nodalMotion::uncoupled() const
{
    bool coupled = false;
    for (label n = 0; n < fe_.nNodes(); ++n)
    {
        const bool held = constraints_->isFixed(unknowns_->start(0, n));
        forCmpts(n, [&](const label, const label, const label u)
        {
            coupled = coupled || constraints_->isTied(u) || constraints_->isFixed(u) != held;
        });
    }
    return !returnReduce(coupled, orOp<bool>());
}


void Foam::nodalMotion::factorise(const vectorField& u)
{
    const bool updated = updates_ || kappa_.empty();
    if (updated) kappa_ = stiffness_->elements(fe_.points() + u);
    K_->clear();
    assemble(incremental_ ? fe_.points() + u : tmp<vectorField>(fe_.points()), u);
    if (factors_->factorise() != feLinearSolver::outcome::OK)
    {
        FatalIOErrorInFunction(dict_)
            << "The mesh motion of region " << fe_.mesh().name()
            << " cannot be solved: no patch holds its displacement"
            << exit(FatalIOError);
    }
    at_ = u;
}


void Foam::nodalMotion::makeOffset(const vectorField& u0)
{
    f_.setSize(x_.size());
    forAll(f_, r) f_[r].setSize(map_->nUnknowns());
    forAll(u0, n) forCmpts(n, [&](const label c, const label r, const label i) { x_[r][i] = u0[n][c]; });
    forAll(f_, r)
    {
        // At tied unknowns what they have beyond their masters' part
        const scalarField values(x_[r]);
        constraints_->imposeHomogeneous(x_[r]);
        for (const label i : constraints_->slaves()) x_[r][i] = values[i] - x_[r][i];
        K_->multiply(x_[r], f_[r]);
    }
    if (nonlinear())
    {
        scalarField R(map_->nUnknowns(), 0);
        addResidual(u0, R);
        constraints_->condense(R);
        f_[0] -= R;
    }
    for (scalarField& f : f_) map_->sum(f);
}


bool Foam::nodalMotion::solve(vectorField& u, const bool affine) const
{
    // K x = f with what is known of x on the right: values that are given, and
    // what ties add to their masters'
    for (scalarField& x : x_)
    {
        x = 0;
        if (affine) for (const label i : constraints_->slaves()) x[i] = constraints_->b(i);
    }
    const auto give = [&]()
    {
        forAll(u, n) forCmpts(n, [&](const label c, const label r, const label i)
        {
            if (constraints_->isGiven(i)) x_[r][i] = u[n][c];
        });
    };
    give();
    forAll(x_, r)
    {
        K_->multiply(x_[r], b_[r]);
        map_->sum(b_[r]);
        forAll(b_[r], i) b_[r][i] = constraints_->isFree(i) ? -b_[r][i] : 0;
        if (affine && f_.size()) forAll(b_[r], i) if (constraints_->isFree(i)) b_[r][i] += f_[r][i];
    }
    if (factors_->solve(b_, x_) != feLinearSolver::outcome::OK) return false;

    give();
    for (scalarField& x : x_) affine ? constraints_->impose(x) : constraints_->imposeHomogeneous(x);
    forAll(u, n) forCmpts(n, [&](const label c, const label r, const label i) { u[n][c] = x_[r][i]; });
    return true;
}


void Foam::nodalMotion::initialise(const bool scalarServes)
{
    number(fieldLayout::kind::VECTOR);
    constrain();
    if (scalarServes && uncoupled())
    {
        boolList held(fe_.nNodes());
        forAll(held, n) held[n] = constraints_->isFixed(unknowns_->start(0, n));
        number(fieldLayout::kind::SCALAR);
        forAll(held, n) if (held[n]) constraints_->fix(unknowns_->start(0, n));
        constraints_->close();
    }
    x_.setSize(layout_->nComponents(0) > 1 || !scalarServes ? 1 : fe_.dim(), scalarField(map_->nUnknowns()));
    b_ = x_;
    for (const elementBlock& block : fe_.blocks())
    {
        scatter_.append(new elementScatter(block, unknowns_()));
    }
    K_.reset(new feMatrix(map_(), map_(), constraints_.get(), scatter_, true));
    factors_.reset(new feFactors(map_(), K_(), solverDict_));
    factorise(vectorField(fe_.nNodes(), Zero));
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::nodalMotion::nodalMotion
(
    const feMesh& fe,
    pointVectorField* boundary,
    const labelUList& heldPatches,
    const dictionary& dict,
    const dictionary& solver,
    const wordList& ownEntries
)
:
    fe_(fe),
    heldPatches_(heldPatches),
    dict_(dict),
    solverDict_(solver),
    incremental_(readIncremental(dict)),
    updates_(dict.getOrDefault<bool>("update", false))
{
    makeBoundary(boundary);
    wordList entries({"configuration", "update"});
    entries.append(ownEntries);
    stiffness_ = meshStiffness::New(fe, walls(*boundary), dict, entries);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::nodalMotion::given(const label node) const
{
    bool all = true;
    forCmpts(node, [&](const label, const label, const label u)
    {
        all = all && constraints_->isGiven(u);
    });
    return all;
}


void Foam::nodalMotion::renew()
{
    // Without ties there is nothing to renew
    if (layout_->nComponents(0) > 1) constrain();
}


void Foam::nodalMotion::adapt(const vectorField& u)
{
    if (!incremental_ && !updates_ && !nonlinear()) return;
    if (returnReduce(u != at_, orOp<bool>())) factorise(u);
    if (incremental_ || nonlinear()) makeOffset(u);
}


// ************************************************************************* //

/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    The Newton loop of a step and the linear solution.
\*---------------------------------------------------------------------------*/

#include "coupledSystem.H"
#include "trapsOff.H"
#include "clockValue.H"
#include "failureAdvice.H"
#include "fourDigits.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::coupledSystem::follow()
{
    if (interfaces_.empty()) return;
    for (feInterface& i : interfaces_) i.follow();

    systemTimes::timer timer(times_, systemTimes::MESH_MOTION);
    for (feRegion& region : regions_) if (region.follower()) region.follower()->followed();
}


void Foam::coupledSystem::followAtStart()
{
    if (interfaces_.empty()) return;
    for (feInterface& i : interfaces_) i.follow();
    for (feRegion& region : regions_) if (region.follower()) region.follower()->followedAtStart();
}


void Foam::coupledSystem::assemble(const bool tangent)
{
    systemTimes::timer timer(times_, systemTimes::ASSEMBLY);
    feMatrix* K = tangent ? &tangent_->K() : nullptr;
    unknowns_->renewConstraints();
    if (K) K->clear();
    R_ = 0;
    for (feRegion& region : regions_) region.assemble(R_, K);
    for (feRegion& region : regions_) region.assembleBodies(R_, K);

    raw_ = R_;
    map().sum(raw_);
    constraints().condense(R_);
    map().sum(R_);
    norms_->update(R_, raw_, tangent_->K(), newton_.nIterations() < 0);
}


void Foam::coupledSystem::apply(const scalarField& x, scalarField& y)
{
    tangent_->K().multiply(x, y);
    scalar motionTime = 0;
    bool moves = false;
    for (feRegion& region : regions_)
    {
        followingMotion* follower = region.follower();
        if (!follower || !follower->hasTangent()) continue;
        const clockValue start(true);
        follower->extendIncrement(x);
        motionTime += start.elapsed();
        follower->addTangent(y);
        moves = true;
    }
    times_.move(systemTimes::SOLVE, systemTimes::MESH_MOTION, motionTime);

    // The rows of K are condensed already; those of the mesh's motion are not
    if (moves) constraints().condense(y);
    map().sum(y);
    forAll(y, u) if (!constraints().isFree(u)) y[u] = 0;
}


void Foam::coupledSystem::reportSingular() const
{
    label block;
    const string what(unknowns_->describe(tangent_->solver().singularUnknown(), block));
    Info<< "The matrix is singular at " << what.c_str() << '.' << nl;
    forAll(unknowns_->blocks(), b)
    {
        if (block >= 0 && block != b) continue;
        const systemUnknowns::block& at = unknowns_->blocks()[b];
        Info<< regions_[at.region].singularAdvice(at.field).c_str() << '.' << nl;
    }
    Info<< flush;
}


bool Foam::coupledSystem::solve()
{
    const label before = tangent_->nFactorisations();
    const auto outcome = tangent_->solve
    (
        [&](const scalarField& x, scalarField& y) { apply(x, y); },
        R_, norms_->rowScale(), newton_.linearTolerance(), dx_, times_
    );
    if (tangent_->nFactorisations() != before) factorsAt_ = std::make_shared<moment>(now());

    switch (outcome)
    {
        case tangentSolver::outcome::OK:
            break;
        case tangentSolver::outcome::SINGULAR:
            reportSingular();
            newton_.fail(newtonControl::SINGULAR);
            return false;
        case tangentSolver::outcome::OUT_OF_MEMORY:
            newton_.fail(newtonControl::OUT_OF_MEMORY);
            return false;
        case tangentSolver::outcome::FAILED:
            newton_.fail(newtonControl::LINEAR_SOLVER);
            return false;
        case tangentSolver::outcome::STALLED:
            newton_.fail(newtonControl::DIVERGED);
            break;
    }
    return true;
}


void Foam::coupledSystem::update()
{
    dx_ *= newton_.relaxation();
    for (feRegion& region : regions_) region.update(dx_);
    follow();
}


Foam::scalar Foam::coupledSystem::minDetJ() const
{
    scalar detJ = GREAT;
    for (const feRegion& region : regions_) detJ = min(detJ, region.minDetJ());
    return returnReduce(detJ, minOp<scalar>());
}


bool Foam::coupledSystem::regionsOk() const
{
    bool ok = true;
    for (const feRegion& region : regions_) ok = ok && region.ok();
    return returnReduce(ok, andOp<bool>());
}


Foam::scalar Foam::coupledSystem::shorten()
{
    scalar part = 1;
    while (part > 0.04 && newton_.tooFar(norms_->largest(), minDetJ()))
    {
        part *= 0.5;
        dx_ *= -0.5;
        for (feRegion& region : regions_) region.update(dx_);
        follow();
        dx_ *= -1;
        assemble(false);
    }
    return part;
}


void Foam::coupledSystem::logIteration(const label nLinear, const scalar part) const
{
    Info<< "  Newton " << newton_.nIterations() << ':';
    for (label b = 0; b < norms_->nBlocks(); ++b)
    {
        Info<< ' ' << unknowns_->blocks()[b].name << ' ' << fourDigits(norms_->scaled(b));
    }
    Info<< ", min det J " << fourDigits(newton_.minDetJ());
    if (nLinear >= 0) Info<< ", linear iterations " << nLinear;
    if (part < 1) Info<< ", " << part << " of the increment";
    Info<< nl;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::coupledSystem::predict(const scalar deltaT, const scalar deltaT0)
{
    staticStage_.select(regions_, kept_.at.time);
    for (feRegion& region : regions_)
    {
        region.timeScheme().setDeltaT(deltaT, deltaT0);
        region.predict(runTime_.value());
    }
    follow();
}


bool Foam::coupledSystem::newtonLoop()
{
    label nLinear = -1;
    tangent_->start();
    while (true)
    {
        // The first tangent is always wanted, a later one perhaps, and the residual
        // alone is much cheaper
        const bool first = newton_.nIterations() < 0;
        assemble(first);
        const scalar part = first ? 1 : shorten();
        if (!regionsOk()) newton_.fail(newtonControl::LINEAR_SOLVER);
        const bool more = newton_.loop(norms_->largest(), norms_->isNil(), minDetJ());
        logIteration(nLinear, part);
        if (!more) break;
        if (tangent_->wantsMatrix(norms_->largest()) && !first) assemble(true);
        if (!solve()) break;
        nLinear = tangent_->nIterations();
        update();
    }
    nIterations_ += newton_.nIterations();
    times_.nIterations += newton_.nIterations();
    return newton_.ok();
}


bool Foam::coupledSystem::step()
{
    const trapsOff guard;
    nIterations_ = 0;
    for (const newtonControl::way& way : newton_.ways())
    {
        const bool isPseudo = newtonControl::isPseudoTransient(way);
        if (isPseudo && !isSteady()) continue;
        if (nIterations_)
        {
            Info<< outcome().c_str() << ": another way, by " << way.name << nl;
            const TimeState time(runTime_);
            restore();
            static_cast<TimeState&>(runTime_) = time;
        }
        if (isPseudo)
        {
            if (pseudoTransient()) break;
            continue;
        }
        predict();
        newton_.start(way, tangent_->patience());
        const bool first = nIterations_ == 0;
        const bool found = newtonLoop();
        if (first) firstNorm_ = ::sqrt(sumSqr(norms_->first()));
        if (found || !newton_.mayTurn()) break;
    }

    for (label b = 0; b < norms_->nBlocks(); ++b)
    {
        Info<< "monolithic:  Solving for " << unknowns_->blocks()[b].name
            << ", Initial residual = " << fourDigits(norms_->firstScaled(b))
            << ", Final residual = " << fourDigits(norms_->scaled(b))
            << ", No Iterations " << nIterations_ << nl;
    }
    return newton_.ok();
}


Foam::string Foam::coupledSystem::outcome() const
{
    OStringStream os;
    os  << newtonControl::outcomeName(newton_.outcome()) << " after "
        << newton_.nIterations() << " iterations";
    return os.str();
}


Foam::string Foam::coupledSystem::placeOfFailure() const
{
    OStringStream os;
    if (newton_.outcome() == newtonControl::INVERTED_ELEMENT)
    {
        for (const feRegion& region : regions_)
        {
            if (returnReduce(region.minDetJ(), minOp<scalar>()) > 0) continue;
            os << "Region " << region.name() << ": " << region.worstElement().c_str() << nl;
        }
    }
    else if (newton_.outcome() < newtonControl::INVERTED_ELEMENT)
    {
        label block;
        os  << "The residual is worst at "
            << unknowns_->describe(norms_->worst(R_), block).c_str() << nl;
    }
    for (const feRegion& region : regions_)
    {
        const auto* advice = dynamic_cast<const failureAdvice*>(&region);
        if (advice) os << advice->adviceOnFailure().c_str();
    }
    return os.str();
}


bool Foam::coupledSystem::smallerMayHelp()
{
    const label outcome = newton_.outcome();

    // A steady step that begins with the same residual is the same problem
    const bool same = isSteady() && firstNorm_ == failedNorm_;
    failedNorm_ = firstNorm_;
    return
        !same && outcome != newtonControl::OUT_OF_MEMORY
     && (outcome != newtonControl::SINGULAR || times_.nSteps > 0);
}


// ************************************************************************* //

/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    The Newton loop of a step and the linear solution.
\*---------------------------------------------------------------------------*/

#include "coupledSystem.H"
#include "trapsOff.H"
#include <limits>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::coupledSystem::follow()
{
    if (interfaces_.empty()) return;
    const label dim = regions_[0].fe().dim();

    for (vectorField motionField::*part : {&motionField::D, &motionField::v, &motionField::a})
    {
        // Each copy of a solid node brings its share
        y_ = 0;
        for (const matchingInterface& i : interfaces_)
        {
            const vectorField& value = i.solid().interfaceMotion()->*part;
            for (const label n : i.solidNodes())
            {
                const label start = map_->start(i.solid().systemNode()[n]);
                for (label a = 0; a < dim; ++a)
                {
                    y_[start + a] = value[n][i.solid().fe().axis(a)]/copies_[start];
                }
            }
        }
        map_->sum(y_);
        for (const matchingInterface& i : interfaces_)
        {
            vectorField& value = i.fluid().interfaceFollower()->*part;
            for (const label n : i.fluidNodes())
            {
                const label start = map_->start(i.fluid().systemNode()[n]);
                for (label a = 0; a < dim; ++a) value[n][i.fluid().fe().axis(a)] = y_[start + a];
            }
        }
    }

    systemTimes::timer timer(times_, systemTimes::MESH_MOTION);
    for (feRegion& region : regions_) region.interfaceMoved();
}


void Foam::coupledSystem::assemble(const bool tangent)
{
    systemTimes::timer timer(times_, systemTimes::ASSEMBLY);
    if (tangent) K_->clear();
    assembled_ = assembled_ || tangent;
    R_ = 0;
    for (feRegion& region : regions_) region.assemble(R_, tangent ? K_.get() : nullptr);

    b_ = R_;
    map_->sum(b_);
    constraints_->condense(R_);
    map_->sum(R_);
    computeNorms(b_);
}


void Foam::coupledSystem::computeNorms(const scalarField& raw)
{
    scalarField free(norms_.size(), 0), reaction(norms_.size(), 0);
    for (const label u : map_->ownedUnknowns())
    {
        (constraints_->isFree(u) ? free : reaction)[block_[u]] +=
            constraints_->isFree(u) ? sqr(R_[u]) : sqr(raw[u]);
    }
    Pstream::listCombineGather(free, plusEqOp<scalar>());
    Pstream::listCombineScatter(free);
    Pstream::listCombineGather(reaction, plusEqOp<scalar>());
    Pstream::listCombineScatter(reaction);

    const bool first = newton_.nIterations() < 0;
    if (first) roundOff_ = roundOff();
    forAll(norms_, b)
    {
        norms_[b] = ::sqrt(free[b]);
        if (first) firstNorms_[b] = norms_[b];
        scales_[b] = max(firstNorms_[b], ::sqrt(reaction[b]));
        scales_[b] = max(scales_[b], roundOff_[b]/newton_.tolerance());
    }

    // Flux of the velocity through a face of an element of mean size
    forAll(norms_, b)
    {
        if (b > 0 && blockRegion_[b] == blockRegion_[b - 1])
        {
            scales_[b] = regions_[blockRegion_[b]].fluxScale();
        }
        if (scales_[b] <= 0) scales_[b] = 1;
    }
    forAll(rowScale_, u) rowScale_[u] = 1/scales_[block_[u]];
}


Foam::scalarField Foam::coupledSystem::roundOff() const
{
    scalarField stiffness(norms_.size(), 0);
    for (const label u : map_->ownedUnknowns()) stiffness[block_[u]] += sqr(K_->diagonal(u));
    Pstream::listCombineGather(stiffness, plusEqOp<scalar>());
    Pstream::listCombineScatter(stiffness);

    forAll(stiffness, b)
    {
        feRegion& region = const_cast<feRegion&>(regions_[blockRegion_[b]]);
        const scalar size =
            region.interfaceMotion()
          ? elementSize_[blockRegion_[b]]/region.timeScheme().displacementByUnknown()
          : region.velocityScale();
        stiffness[b] = 10*std::numeric_limits<scalar>::epsilon()*size*::sqrt(stiffness[b]);
    }
    return stiffness;
}


void Foam::coupledSystem::apply(const scalarField& x, scalarField& y)
{
    K_->multiply(x, y);
    scalar motionTime = 0;
    bool moves = false;
    for (feRegion& region : regions_)
    {
        if (!region.hasMotionTangent()) continue;
        motionTime -= region.motionTime();
        region.addMotionTangent(x, y);
        motionTime += region.motionTime();
        moves = true;
    }
    times_.move(systemTimes::SOLVE, systemTimes::MESH_MOTION, motionTime);

    // The rows of K are condensed already; those of the mesh's motion are not
    if (moves) constraints_->condense(y);
    map_->sum(y);
    forAll(y, u) if (!constraints_->isFree(u)) y[u] = 0;
}


bool Foam::coupledSystem::factorise()
{
    systemTimes::timer timer(times_, systemTimes::FACTORISATION);
    const auto outcome = factors_->factorise();
    if (outcome != feLinearSolver::outcome::OK)
    {
        reportSingular(factors_->solver().singularUnknown());
        return false;
    }
    // Operations of a factorisation, done at some ten times the rate of a
    // back-substitution's, which touches each entry of the factors once
    const auto& stats = factors_->solver().stats();
    makingCost_ = stats.nFlops/(20*max(stats.nNonzeros, 1.0));
    factorCost_ = makingCost_;
    factorUses_ = 0;
    factorised_ = true;
    ++times_.nFactorisations;
    return true;
}


void Foam::coupledSystem::reportSingular(const label unknown) const
{
    label owner = -1;
    if (unknown >= 0) owner = map_->numbering().whichProcID(unknown);

    string what("an unknown that could not be found");
    if (owner == Pstream::myProcNo())
    {
        forAll(regions_, r) forAll(regions_[r].systemNode(), n)
        {
            const label start = map_->start(regions_[r].systemNode()[n]);
            for (label c = 0; c < regions_[r].nUnknowns(n); ++c)
            {
                if (map_->global(start + c) != unknown) continue;
                OStringStream os;
                os  << regions_[r].unknownName(c) << " of region " << regions_[r].name()
                    << " at " << regions_[r].fe().points()[n];
                what = os.str();
            }
        }
    }
    if (owner >= 0)
    {
        List<string> all(Pstream::nProcs());
        all[Pstream::myProcNo()] = what;
        Pstream::gatherList(all);
        Pstream::scatterList(all);
        what = all[owner];
    }
    Info<< "The matrix is singular at " << what.c_str() << '.' << nl
        << "A pressure is undetermined where no patch lets the fluid out"
        << " (openBoundary, pRefPoint in feSchemes);" << nl
        << "a displacement is where nothing holds the solid." << endl;
}


Foam::label Foam::coupledSystem::solveOnce(const label limit)
{
    systemTimes::timer timer(times_, systemTimes::SOLVE);
    forAll(b_, u) b_[u] = -R_[u]*rowScale_[u];

    const auto A = [&](const scalarField& x, scalarField& y)
    {
        apply(x, y);
        y *= rowScale_;
    };
    const auto Minv = [&](const scalarField& y, scalarField& x)
    {
        y_ = y/rowScale_;
        factors_->solve(y_, x);
        constraints_->distribute(x);
    };
    return gmres_->solve(A, Minv, b_, dx_, newton_.linearTolerance(), limit);
}


bool Foam::coupledSystem::solve()
{
    bool fresh = false;
    if (!factorised_)
    {
        if (!factorise()) { newton_.fail(feRegion::SINGULAR); return false; }
        fresh = true;
    }

    // With old factors no more iterations than new ones would cost
    const label most = gmres_->maxIter();
    label limit = fresh ? most : min(most, label(10 + makingCost_));
    label n = solveOnce(limit);
    if (n > limit && !fresh)
    {
        if (!factorise()) { newton_.fail(feRegion::SINGULAR); return false; }
        limit = most;
        n = solveOnce(limit);
    }
    if (n > limit) newton_.fail(feRegion::DIVERGED);

    // Renew the factors when a solution with them costs more than the average
    // of all since they were made, their making included
    factorCost_ += n;
    ++factorUses_;
    if (factorUses_ > 1 && n > factorCost_/factorUses_) factorised_ = false;

    nLinear_ = n;
    times_.nLinear += n;
    return true;
}


void Foam::coupledSystem::update()
{
    dx_ *= newton_.relaxation();
    for (feRegion& region : regions_) region.update(dx_);
    follow();
}


void Foam::coupledSystem::logIteration(const label nLinear) const
{
    Info<< "  Newton " << newton_.nIterations() << ':';
    forAll(norms_, b) Info<< ' ' << blockNames_[b] << ' ' << norms_[b]/scales_[b];
    scalar detJ = GREAT;
    for (const feRegion& region : regions_) detJ = min(detJ, region.minDetJ());
    Info<< ", min det J " << returnReduce(detJ, minOp<scalar>());
    if (nLinear >= 0) Info<< ", linear iterations " << nLinear;
    Info<< nl;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::coupledSystem::step()
{
    const trapsOff guard;
    times_.startStep();
    for (feRegion& region : regions_)
    {
        region.timeScheme().setDeltaT(runTime_.deltaTValue());
        region.predict(runTime_.value());
    }
    follow();

    newton_.start();
    nLinear_ = -1;
    while (true)
    {
        // The tangent only when it is wanted: the residual is much cheaper
        assemble(!assembled_);
        scalar detJ = GREAT;
        for (const feRegion& region : regions_) detJ = min(detJ, region.minDetJ());

        // What is not a number must not get lost in a maximum
        scalar norm = 0;
        forAll(norms_, b)
        {
            const scalar r = norms_[b]/scales_[b];
            norm = std::isfinite(r) ? max(norm, r) : r;
            if (!std::isfinite(r)) break;
        }
        const bool more = newton_.loop(norm, returnReduce(detJ, minOp<scalar>()));
        logIteration(nLinear_);
        if (!more) break;
        assemble(true);
        if (!solve()) break;
        update();
    }

    times_.nIterations += newton_.nIterations();
    forAll(norms_, b)
    {
        Info<< "monolithic:  Solving for " << blockNames_[b]
            << ", Initial residual = " << firstNorms_[b]/scales_[b]
            << ", Final residual = " << norms_[b]/scales_[b]
            << ", No Iterations " << newton_.nIterations() << nl;
    }
    return newton_.ok();
}


void Foam::coupledSystem::tangentAction(const scalarField& dx, scalarField& y)
{
    apply(dx, y);
}


// ************************************************************************* //

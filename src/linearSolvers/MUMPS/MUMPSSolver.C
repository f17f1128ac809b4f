/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

\*---------------------------------------------------------------------------*/

#include "MUMPSSolver.H"
#include "MUMPSInstance.H"
#include "checkMemory.H"
#include "blasThreads.H"
#include "ListOps.H"
#include "nodeOrdering.H"
#include "clockTime.H"
#include "PstreamReduceOps.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(MUMPSSolver, 0);
    addToRunTimeSelectionTable(feLinearSolver, MUMPSSolver, dictionary);

    //- MUMPS counts from 1
    static List<int> fromOne(const labelUList& numbers)
    {
        List<int> result(numbers.size());
        forAll(numbers, i)
        {
            result[i] = int(numbers[i]) + 1;
        }
        return result;
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::MUMPSSolver::setControls()
{
    MUMPSInstance& mumps = *mumps_;
    const bool distributed = Pstream::parRun();

    // Silent
    mumps.icntl(1) = mumps.icntl(2) = mumps.icntl(3) = -1;
    mumps.icntl(4) = 0;

    mumps.icntl(5) = 0;                             // assembled
    mumps.icntl(18) = 3;                            // distributed matrix
    mumps.icntl(20) = distributed ? 10 : 0;         // right-hand side
    mumps.icntl(21) = distributed ? 1 : 0;          // solution

    mumps.icntl(28) = 1;                            // sequential analysis
    mumps.icntl(7) = position_.size() ? 1 : 7;      // ordering
    mumps.icntl(8) = controls_.scaling;
    mumps.icntl(13) = 1;        // no ScaLAPACK: else null pivots stay unseen
    mumps.icntl(14) = memoryRelaxation_;
    mumps.icntl(23) = controls_.maxMemory;
    mumps.cntl(1) = controls_.pivotThreshold;

    if (controls_.blockLowRank > 0)
    {
        mumps.icntl(35) = 2;
        mumps.cntl(7) = controls_.blockLowRank;
    }

    for (const auto& c : controls_.ICNTL)
    {
        mumps.icntl(c.first()) = c.second();
    }
}


void Foam::MUMPSSolver::prepareSolution()
{
    const label n = max(mumps_->info(23), 1);

    if (Pstream::parRun()) solved_.setSize(n);
    planned_ = false;
}


int Foam::MUMPSSolver::solveOnly(UList<scalar>& x, const label nRhs)
{
    MUMPSInstance& mumps = *mumps_;
    mumps->nrhs = nRhs;

    if (!Pstream::parRun())
    {
        mumps->rhs = x.data();
        mumps->lrhs = owned_.size();
        return mumps.run(MUMPSInstance::SOLVE);
    }

    solution_.setSize(nRhs*solved_.size());
    mumps->nloc_rhs = owned_.size();
    mumps->lrhs_loc = max(owned_.size(), 1);
    mumps->irhs_loc = owned_.data();
    mumps->rhs_loc = x.data();
    mumps->lsol_loc = solved_.size();
    mumps->isol_loc = solved_.data();
    mumps->sol_loc = solution_.data();

    const int status = mumps.run(MUMPSInstance::SOLVE);

    if (status >= 0)
    {
        if (!planned_)
        {
            const label n = mumps.info(23);
            transfer_.plan(unknowns_, SubList<int>(solved_, n));
            planned_ = true;
        }
        for (label r = 0; r < nRhs; ++r)
        {
            SubList<scalar> column(x, owned_.size(), r*owned_.size());
            transfer_.apply
            (
                SubList<scalar>(solution_, solved_.size(), r*solved_.size()),
                column
            );
        }
    }

    return status;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::MUMPSSolver::MUMPSSolver(const dictionary& dict)
:
    controls_(dict),
    memoryRelaxation_(controls_.memoryRelaxation)
{}


// * * * * * * * * * * * * * * * * Destructor  * * * * * * * * * * * * * * * //

Foam::MUMPSSolver::~MUMPSSolver()
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::MUMPSSolver::analyse(const feMatrixPattern& pattern)
{
    const clockTime timer;

    unknowns_ = pattern.unknowns;
    row_ = fromOne(pattern.row);
    col_ = fromOne(pattern.col);
    owned_.setSize(unknowns_.localSize());
    forAll(owned_, i)
    {
        owned_[i] = int(unknowns_.toGlobal(i)) + 1;
    }

    position_.clear();
    if (controls_.ordering == MUMPSControls::orderings::METIS)
    {
        position_ = fromOne(nodeOrdering(pattern).positions(pattern));
    }

    // A new structure: the former one's factors are of another sparsity
    mumps_.reset();
    workspace_ = hugePages();
    mumps_.reset(new MUMPSInstance());
    setControls();

    MUMPSInstance& mumps = *mumps_;
    mumps->n = unknowns_.size();
    mumps->nnz_loc = row_.size();
    mumps->irn_loc = row_.data();
    mumps->jcn_loc = col_.data();
    mumps->perm_in = position_.size() ? position_.data() : nullptr;

    const blasThreads threads(controls_.threads);
    const int status = mumps.run(MUMPSInstance::ANALYSE);

    if (status < 0)
    {
        FatalErrorInFunction
            << "MUMPS cannot analyse a matrix of " << unknowns_.size()
            << " unknowns: error " << status << ' ' << mumps.infog(2)
            << exit(FatalError);
    }

    checkMemory(mumps.info(15), controls_.maxMemory, unknowns_.size());

    // INFO(8): number of values with the relaxation
    setWorkspace(mumps.info(8) < 0 ? -1e6*mumps.info(8) : mumps.info(8));

    statistics_ = statistics();
    statistics_.memory = mumps.infog(17);
    statistics_.analysisTime = timer.elapsedTime();
}


Foam::feLinearSolver::outcome Foam::MUMPSSolver::factorise
(
    const UList<scalar>& values
)
{
    const clockTime timer;
    MUMPSInstance& mumps = *mumps_;

    ++statistics_.nFactorisations;

    singularUnknown_ = notFinite(values, row_);
    if (singularUnknown_ != -1)
    {
        return outcome::SINGULAR;
    }

    const blasThreads threads(controls_.threads);
    mumps->a_loc = const_cast<scalar*>(values.cdata());

    outcome result = tryFactorise();

    if (result == outcome::OK)
    {
        statistics_.memory =
            mumps.infog(19)
          + returnReduce(8e-6*workspace_.size(), sumOp<scalar>());
        statistics_.nNonzeros = mumps.countg(29);
        statistics_.nFlops = mumps.rinfog(3);

        prepareSolution();
        singularUnknown_ = nullVector(values);
        if (singularUnknown_ != -1)
        {
            result = outcome::SINGULAR;
        }
    }
    else if (result == outcome::SINGULAR)
    {
        singularUnknown_ = nullPivot();
    }

    mumps->a_loc = nullptr;
    statistics_.factorTime = timer.elapsedTime();

    return result;
}


Foam::feLinearSolver::outcome Foam::MUMPSSolver::solve
(
    scalarField& x,
    const label nRhs
)
{
    const clockTime timer;

    const blasThreads threads(controls_.threads);
    const int status = solveOnly(x, nRhs);

    ++statistics_.nSolutions;
    outcome result = outcomeOf(status);

    if (result != outcome::OK)
    {
        Info<< "MUMPS: error " << status << ' ' << mumps_->infog(2)
            << " in the solution" << endl;
    }
    else
    {
        singularUnknown_ = notFinite(x, owned_);
        if (singularUnknown_ != -1)
        {
            result = outcome::SINGULAR;
        }
    }

    statistics_.solveTime = timer.elapsedTime();

    return result;
}


// ************************************************************************* //

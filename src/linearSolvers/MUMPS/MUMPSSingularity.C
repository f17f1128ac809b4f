/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Singular matrices in MUMPSSolver.

    A null pivot ends the factorisation.  More often round-off makes it a tiny
    one, which passes silently.  The smallest and the largest pivot of the scaled
    matrix come for nothing: if their ratio is suspect, the matrix is scaled to
    rows and columns of maximum 1 and solved with a random right-hand side of
    unit variance.  The expected norm of the solution is the Frobenius norm of
    the inverse, whatever the number of unknowns; for a singular matrix the
    solution is close to a null vector.

\*---------------------------------------------------------------------------*/

#include "MUMPSSolver.H"
#include "MUMPSInstance.H"
#include "PstreamReduceOps.H"
#include "Random.H"

#include <cmath>
#include <limits>

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

namespace Foam
{
    //- Ratio of pivots that asks for a closer look
    static const scalar suspectPivots = 1e-11;

    //- Condition of a matrix without a meaningful inverse
    static const scalar singularCondition = 1e12;

    //- Maximum over the ranks, entry by entry
    static void maxOverRanks(scalarList& f)
    {
        MPI_Allreduce
        (
            MPI_IN_PLACE, f.data(), f.size(), MPI_DOUBLE, MPI_MAX,
            MUMPSInstance::communicator()
        );
    }

    //- Factors of rows and columns for maxima of about 1
    static void equilibrate
    (
        const UList<scalar>& values,
        const UList<int>& row,
        const UList<int>& col,
        scalarList& r,
        scalarList& c
    )
    {
        scalarList rowMax(r.size()), colMax(c.size());

        for (label pass = 0; pass < 4; ++pass)
        {
            rowMax = 0;
            colMax = 0;
            forAll(values, k)
            {
                const label i = row[k] - 1, j = col[k] - 1;
                const scalar a = r[i]*std::abs(values[k])*c[j];
                rowMax[i] = max(rowMax[i], a);
                colMax[j] = max(colMax[j], a);
            }
            maxOverRanks(rowMax);
            maxOverRanks(colMax);
            forAll(r, i)
            {
                r[i] /= rowMax[i] > 0 ? std::sqrt(rowMax[i]) : 1;
                c[i] /= colMax[i] > 0 ? std::sqrt(colMax[i]) : 1;
            }
        }
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::label Foam::MUMPSSolver::notFinite
(
    const UList<scalar>& f,
    const UList<int>& numbers
)
{
    // Without a branch in the loop, for its speed
    constexpr scalar great = std::numeric_limits<scalar>::max();
    int bad = 0;
    for (const scalar x : f)
    {
        bad |= !(std::abs(x) <= great);
    }

    int unknown = -1;
    if (bad)
    {
        forAll(f, i)
        {
            if (!std::isfinite(f[i]))
            {
                unknown = numbers[i % numbers.size()] - 1;
                break;
            }
        }
    }

    MPI_Allreduce
    (
        MPI_IN_PLACE, &unknown, 1, MPI_INT, MPI_MAX,
        MUMPSInstance::communicator()
    );

    return unknown;
}


Foam::label Foam::MUMPSSolver::nullPivot()
{
    MUMPSInstance& mumps = *mumps_;

    mumps.icntl(24) = 1;
    const outcome result = tryFactorise();
    mumps.icntl(24) = 0;

    int unknown = -1;
    if (result == outcome::OK && Pstream::master() && mumps.infog(28) > 0)
    {
        unknown = mumps->pivnul_list[0] - 1;
    }
    MPI_Bcast(&unknown, 1, MPI_INT, 0, MUMPSInstance::communicator());

    return unknown;
}


Foam::label Foam::MUMPSSolver::nullVector(const UList<scalar>& values)
{
    const scalar smallest = mumps_->rinfog(20), largest = mumps_->rinfog(21);

    if (debug)
    {
        Info<< "MUMPS: pivots " << smallest << " to " << largest
            << ", delayed " << mumps_->infog(13) << endl;
    }

    if (smallest > suspectPivots*largest)
    {
        return -1;
    }

    scalarList r(unknowns_.size(), scalar(1)), c(r);
    equilibrate(values, row_, col_, r, c);

    Random random(label(1234567) + Pstream::myProcNo());
    scalarField x(owned_.size());
    forAll(x, i)
    {
        x[i] = random.GaussNormal<scalar>()/r[owned_[i] - 1];
    }

    if (solveOnly(x, 1) < 0)
    {
        return -1;
    }

    struct { double value; int unknown; } largestX{0, -1};
    scalar sumSqr = 0;
    forAll(x, i)
    {
        const scalar s = std::abs(x[i]/c[owned_[i] - 1]);
        sumSqr += s*s;
        if (!(s <= largestX.value))
        {
            largestX = {std::isfinite(s) ? s : VGREAT, owned_[i] - 1};
        }
    }
    MPI_Allreduce
    (
        MPI_IN_PLACE, &largestX, 1, MPI_DOUBLE_INT, MPI_MAXLOC,
        MUMPSInstance::communicator()
    );
    const scalar condition = std::sqrt(returnReduce(sumSqr, sumOp<scalar>()));

    if (debug)
    {
        Info<< "MUMPS: condition about " << condition << endl;
    }

    // Not finite: singular, too
    return condition <= singularCondition ? -1 : largestX.unknown;
}


// ************************************************************************* //

/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "feLaplacianMotionSolver.H"
#include "subDictOrEmpty.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(feLaplacianMotionSolver, 0);
    addToRunTimeSelectionTable(motionSolver, feLaplacianMotionSolver, dictionary);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::feLaplacianMotionSolver::feLaplacianMotionSolver
(
    const polyMesh& mesh,
    const IOdictionary& dict
)
:
    displacementMotionSolver(mesh, dict, typeName)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::feLaplacianMotionSolver::solve()
{
    if (!motion_.valid())
    {
        dictionary coeffs(coeffDict());
        dictionary solver(subDictOrEmpty(coeffs, "linearSolver"));
        solver.add("type", "MUMPS");
        coeffs.remove("linearSolver");
        fe_.reset(new feMesh(mesh(), 1, dictionary::null, points0()));
        motion_.reset
        (
            new laplaceMotion(fe_(), &pointDisplacement(), labelList(), coeffs, solver)
        );
    }

    pointDisplacement().correctBoundaryConditions();
    vectorField D(fe_->interpolate<vector>(pointDisplacement().primitiveField()));
    motion_->extend(D);
    fe_->toPoints<vector>(D, pointDisplacement().primitiveFieldRef());
}


Foam::tmp<Foam::pointField> Foam::feLaplacianMotionSolver::curPoints() const
{
    tmp<pointField> tpoints(new pointField(points0() + pointDisplacement().primitiveField()));
    twoDCorrectPoints(tpoints.ref());
    return tpoints;
}


void Foam::feLaplacianMotionSolver::updateMesh(const mapPolyMesh& map)
{
    displacementMotionSolver::updateMesh(map);
    motion_.clear();
    fe_.clear();
}


// ************************************************************************* //

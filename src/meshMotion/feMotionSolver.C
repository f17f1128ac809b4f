/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "feMotionSolver.H"
#include "elementQuality.H"
#include "subDictOrEmpty.H"
#include "gatherAll.H"
#include "OStringStream.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * * * * Solvers * * * * * * * * * * * * * * * * //

namespace Foam
{

// One for each meshMotion, with its name
#define makeMotionSolver(Class, Name)                                          \
    class Class : public feMotionSolver                                        \
    {                                                                          \
    public:                                                                    \
        TypeName(Name);                                                        \
        Class(const polyMesh& mesh, const IOdictionary& dict)                  \
        :                                                                      \
            feMotionSolver(mesh, dict, typeName)                               \
        {}                                                                     \
    };                                                                         \
    defineTypeNameAndDebug(Class, 0);                                          \
    addToRunTimeSelectionTable(motionSolver, Class, dictionary)

makeMotionSolver(feLaplacianMotionSolver, "feLaplacian");
makeMotionSolver(feElasticityMotionSolver, "feElasticity");

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::feMotionSolver::makeMotion()
{
    dictionary coeffs(subDictOrEmpty(*this, type() + "Coeffs"));
    dictionary solver(subDictOrEmpty(coeffs, "linearSolver"));
    solver.add("type", "MUMPS");
    coeffs.remove("linearSolver");
    dictionary dict(objectPath());
    dict.add("motionSolver", type());
    dict.add(word(type() + "Coeffs"), coeffs);
    fe_.reset(new feMesh(mesh(), 1, dictionary::null, points0()));
    motion_ = meshMotion::New(fe_(), &pointDisplacement(), labelList(), dict, solver);
}


Foam::word Foam::feMotionSolver::nearestMoving
(
    const point& reference,
    const vectorField& D
) const
{
    word name("none");
    scalar nearest = GREAT;
    forAll(mesh().boundaryMesh(), patchi) for (const label n : fe_->patchNodes(patchi))
    {
        const scalar distance = mag(fe_->points()[n] - reference);
        if (mag(D[n]) < VSMALL || distance >= nearest || !motion_->given(n)) continue;
        nearest = distance;
        name = mesh().boundaryMesh()[patchi].name();
    }
    return name;
}


void Foam::feMotionSolver::move(vectorField& D, const vectorField& last, const label nSteps)
{
    const vectorField way(D - last);
    D = last;
    fe_->toPoints<vector>(D, pointDisplacement().primitiveFieldRef());
    for (label k = 1; k <= nSteps; ++k)
    {
        motion_->adapt(D);
        motion_->renew();
        D = last + (scalar(k)/nSteps)*way;
        if (!motion_->extend(D))
        {
            FatalErrorInFunction
                << "The linear problem of the mesh motion of region " << mesh().name()
                << " could not be solved" << exit(FatalError);
        }
        motion_->settle(D);
    }
}


bool Foam::feMotionSolver::inverts(const vectorField& D) const
{
    return forecast(fe_(), fe_->points() + D, vectorField()).steps <= 0;
}


void Foam::feMotionSolver::fail(const vectorField& D, const vectorField& last) const
{
    const feMesh& fe = fe_();
    const inversionForecast now = forecast(fe, fe.points() + D, vectorField());
    const auto least = [&](const vectorField& displacement)
    {
        scalar s = GREAT;
        for (const auto& block : qualities(fe, fe.points() + displacement))
        {
            for (const elementQuality& q : block) s = min(s, q.scaledJacobian);
        }
        return returnReduce(s, minOp<scalar>());
    };
    const scalar first = least(vectorField(D.size(), Zero)), before = least(last), worst = least(D);

    // The rank that has the element knows where it is
    OStringStream where;
    if (now.element >= 0)
    {
        const elementBlock& block = fe.blocks()[now.block];
        point reference = Zero, place = Zero;
        for (label i = 0; i < block.nVertices(); ++i)
        {
            const label n = block.element(now.element)[i];
            reference += fe.points()[n]/block.nVertices();
            place += (fe.points()[n] + D[n])/block.nVertices();
        }
        where
            << "cell " << block.cells[now.element] << " (undeformed at " << reference
            << ", now at " << place << "), near patch " << nearestMoving(reference, D);
    }
    string place;
    for (const string& s : gatherAll<string>(List<string>(1, where.str()))) place += s;
    FatalErrorInFunction
        << "The motion of region " << mesh().name() << " inverts elements at time "
        << mesh().time().timeName() << ": " << place.c_str() << '.' << nl
        << "The smallest scaled Jacobian: " << first << " undeformed, " << before
        << " at the last time, " << worst << " now." << nl
        << "What helps: motionSolver feElasticity (model neoHookean) for very large motion, smaller"
        << " time steps with it, another stiffness with feLaplacian, or a new mesh."
        << exit(FatalError);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::feMotionSolver::feMotionSolver
(
    const polyMesh& mesh,
    const IOdictionary& dict,
    const word& type
)
:
    displacementMotionSolver(mesh, dict, type)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::feMotionSolver::solve()
{
    if (!motion_.valid()) makeMotion();

    const vectorField last(fe_->interpolate<vector>(pointDisplacement().primitiveField()));
    pointDisplacement().correctBoundaryConditions();
    const vectorField given(fe_->interpolate<vector>(pointDisplacement().primitiveField()));
    vectorField D(given);
    move(D, last, 1);
    if (inverts(D))
    {
        const vectorField first(D);
        bool failed = true;
        for (label n = 2; motion_->hasSteps() && failed && n <= 16; n *= 2)
        {
            D = given;
            move(D, last, n);
            failed = inverts(D);
            if (failed) continue;
            Info<< "The motion of region " << mesh().name() << " inverts elements in one step: made in "
                << n << " parts" << endl;
        }
        if (failed) fail(first, last);
    }
    fe_->toPoints<vector>(D, pointDisplacement().primitiveFieldRef());
}


Foam::tmp<Foam::pointField> Foam::feMotionSolver::curPoints() const
{
    tmp<pointField> tpoints(new pointField(points0() + pointDisplacement().primitiveField()));
    twoDCorrectPoints(tpoints.ref());
    return tpoints;
}


void Foam::feMotionSolver::updateMesh(const mapPolyMesh& map)
{
    displacementMotionSolver::updateMesh(map);
    motion_.clear();
    fe_.clear();
}


// ************************************************************************* //

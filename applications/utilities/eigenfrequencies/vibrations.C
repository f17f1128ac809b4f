/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "vibrations.H"
#include "IStringStream.H"
#include "Random.H"
#include <Spectra/SymGEigsShiftSolver.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- y = values x, in the form that Spectra wants
struct productWith
{
    typedef double Scalar;
    const feMatrixPattern& pattern;
    const scalarField& values;

    Eigen::Index rows() const { return pattern.unknowns.localSize(); }
    Eigen::Index cols() const { return rows(); }

    void perform_op(const double* x, double* y) const
    {
        std::fill(y, y + rows(), 0.0);
        forAll(values, k) y[pattern.row[k]] += values[k]*x[pattern.col[k]];
    }
};


//- y = A^-1 x with the factors that a solver has
struct solutionWith
{
    typedef double Scalar;
    feLinearSolver& solver;
    const label n;

    Eigen::Index rows() const { return n; }
    Eigen::Index cols() const { return n; }
    void set_shift(const double) {}

    void perform_op(const double* x, double* y) const
    {
        scalarField b(UList<scalar>(const_cast<double*>(x), n));
        solver.solve(b);
        std::copy(b.begin(), b.end(), y);
    }
};


template<Spectra::GEigsMode mode>
static vibrations::result solve
(
    solutionWith& inverse,
    productWith& metric,
    const scalarField& start,
    const label n,
    const scalar s
)
{
    using namespace Spectra;
    const label nAll = min(n, metric.rows() - 1), space = min(max(2*nAll, nAll + 20), metric.rows());
    SymGEigsShiftSolver<solutionWith, productWith, mode> lanczos(inverse, metric, nAll, space, -sqr(s));
    lanczos.init(start.begin());
    const bool byM = mode == GEigsMode::ShiftInvert;
    lanczos.compute(byM ? SortRule::LargestMagn : SortRule::SmallestAlge, 1000, 1e-11, SortRule::SmallestAlge);

    vibrations::result r;
    if (lanczos.info() != CompInfo::Successful)
    {
        r.failure = "Lanczos' method has not converged: ask for fewer frequencies";
        return r;
    }
    const Eigen::VectorXd values = lanczos.eigenvalues();
    const Eigen::MatrixXd modes = lanczos.eigenvectors();
    r.omega.setSize(values.size());
    r.modes.setSize(values.size(), scalarField(metric.rows()));
    forAll(r.omega, k)
    {
        r.omega[k] = ::sqrt(max(values[k], 0.0));
        forAll(r.modes[k], i) r.modes[k][i] = modes(i, k);
    }
    return r;
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalarField Foam::vibrations::tangent(const bool solids, const scalar deltaT)
{
    const dictionary dict(IStringStream(deltaT > 0 ? "type Euler;" : "type steady;")());
    matrix_->clear();
    scalarField R(system_.map().nUnknowns(), 0);
    for (feRegion& region : system_.regions())
    {
        if (region.leads() != solids) continue;
        autoPtr<feTimeScheme> scheme(feTimeScheme::New(dict));
        if (deltaT > 0) scheme->setDeltaT(deltaT);
        region.exchange(scheme);
        region.assemble(R, matrix_.get());
        region.assembleBodies(R, matrix_.get());
        region.exchange(scheme);
    }
    scalarField values;
    matrix_->values(values);
    return values;
}


Foam::scalarField Foam::vibrations::shifted(const scalar s, const bool wet)
{
    scalarField A(K_);
    if (s > 0) A += sqr(s)*M_;
    // Displacement by velocity of Euler's step: 1/s
    if (wet) A += s*tangent(false, 1/s);
    else forAll(A, k)
    {
        // Of the fluids alone
        if (pattern_.row[k] == pattern_.col[k] && !solid_[pattern_.row[k]]) A[k] = 1;
    }
    return A;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::vibrations::vibrations(coupledSystem& system)
:
    system_(system)
{
    UPtrList<elementScatter> scatter;
    for (feRegion& region : system.regions())
    {
        for (elementScatter& s : region.scatter()) scatter.append(&s);
    }
    matrix_.reset(new feMatrix(system.map(), system.map(), &system.constraints(), scatter));
    pattern_.unknowns = system.map().numbering();
    matrix_->triplets(pattern_.row, pattern_.col);

    K_ = tangent(true, 0);

    // Of a very short step, in which nothing but inertia counts
    const scalar deltaT = 1e-15;
    M_ = deltaT*tangent(true, deltaT);
    solid_ = boolList(system.map().nUnknowns(), false);
    forAll(K_, k) if (K_[k] != 0 || M_[k] != 0) solid_[pattern_.row[k]] = true;
    boolList isFree(system.map().nUnknowns());
    forAll(isFree, u) isFree[system.map().global(u)] = system.constraints().isFree(u);
    forAll(M_, k) if (!isFree[pattern_.row[k]]) M_[k] = 0;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::vibrations::hasFluids() const
{
    for (const feRegion& region : system_.regions()) if (!region.leads()) return true;
    return false;
}


Foam::vibrations::result Foam::vibrations::find(const label n, const scalar s, const bool wet)
{
    autoPtr<feLinearSolver> solver(feLinearSolver::New(system_.solution().subDict("linearSolver")));
    solver->analyse(pattern_);
    result r;
    const auto outcome = solver->factorise(shifted(s, wet));
    if (outcome != feLinearSolver::outcome::OK)
    {
        r.failure = "The solids are not held, or the shift is a frequency: the matrix is " + feLinearSolver::outcomeNames[outcome];
        return r;
    }

    // Obeys what has no inertia
    Random random(1);
    scalarField start(pattern_.unknowns.localSize());
    for (scalar& x : start) x = random.GaussNormal<scalar>();
    scalarField Mx(start.size());
    solutionWith inverse{*solver, start.size()};
    productWith mass{pattern_, M_}, stiffness{pattern_, K_};
    mass.perform_op(start.begin(), Mx.begin());
    inverse.perform_op(Mx.begin(), start.begin());

    r =
        wet
      ? solve<Spectra::GEigsMode::Buckling>(inverse, stiffness, start, n, s)
      : solve<Spectra::GEigsMode::ShiftInvert>(inverse, mass, start, n, s);
    return r;
}


// ************************************************************************* //

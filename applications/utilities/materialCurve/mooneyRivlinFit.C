/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "mooneyRivlinFit.H"
#include "unknownEntries.H"
#include <Eigen/Dense>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- The material with c1 = 1 and another coefficient
static autoPtr<solidMaterial> lawWith(const word& coefficient)
{
    dictionary dict;
    dict.add("type", "MooneyRivlin");
    dict.add("rho", 1);
    dict.add("c1", 1);
    if (coefficient != "c1") dict.add(coefficient, 1);
    return solidMaterial::New(dict);
}


//- Whether deviations count beside the loads
static bool relative(const dictionary& fit)
{
    const word weights(fit.lookupOrDefault<word>("weights", "relative"));
    if (weights == "relative" || weights == "absolute") return weights == "relative";
    FatalIOErrorInFunction(fit)
        << "Unknown weights " << weights << ". Valid: 2(relative absolute)" << exit(FatalIOError);
    return true;
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::dictionary Foam::mooneyRivlinFit(const dictionary& fit, const measuredLoads& measured)
{
    reportUnknownEntries(fit, {"coefficients", "weights"});
    const wordList names(fit.get<wordList>("coefficients"));
    const bool weighted = relative(fit);
    label nRows = 0;
    forAllConstIters(measured, iter) for (const auto& point : iter.val()) nRows += point.second() != 0;
    if (nRows < names.size())
    {
        FatalIOErrorInFunction(fit)
            << "Found " << nRows << " measured loads for " << names.size()
            << " coefficients, expected as many at least" << exit(FatalIOError);
    }

    // With c1 alone, and what each other one adds to it
    Eigen::MatrixXd A(nRows, names.size());
    Eigen::VectorXd b(nRows);
    const autoPtr<solidMaterial> first = lawWith("c1");
    const materialTest base(first());
    forAll(names, k)
    {
        const autoPtr<solidMaterial> law = lawWith(names[k]);
        const materialTest test(law());
        label row = 0;
        forAllConstIters(measured, iter) for (const auto& point : iter.val())
        {
            if (point.second() == 0) continue;
            const auto m = materialTest::mode(iter.key());
            const scalar own = base.load(m, point.first());
            const scalar s = names[k] == "c1" ? own : test.load(m, point.first()) - own;
            A(row, k) = weighted ? s/point.second() : s;
            b[row++] = weighted ? 1 : point.second();
        }
    }

    // Columns of one size: the powers of the invariants differ much
    const Eigen::VectorXd size = A.colwise().norm();
    const Eigen::VectorXd c = (A*size.cwiseInverse().asDiagonal()).colPivHouseholderQr().solve(b);
    dictionary dict;
    dict.add("type", "MooneyRivlin");
    forAll(names, k) dict.add(names[k], c[k]/size[k]);
    return dict;
}


Foam::scalar Foam::deviation
(
    const materialTest& test,
    const materialTest::mode m,
    const List<Tuple2<scalar, scalar>>& points
)
{
    scalar sum = 0;
    label n = 0;
    for (const auto& point : points)
    {
        if (point.second() == 0) continue;
        sum += sqr(test.load(m, point.first())/point.second() - 1);
        ++n;
    }
    return ::sqrt(sum/max(n, label(1)));
}


// ************************************************************************* //

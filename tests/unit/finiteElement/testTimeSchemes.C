/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Tests of the time schemes: energy of an oscillator, a + w^2 D = 0, from step
    to step.
\*---------------------------------------------------------------------------*/

#include "timeField.H"
#include "IStringStream.H"
#include <gtest/gtest.h>

using namespace Foam;

namespace
{

const scalar w = 3, dt = 0.2;

scalar energy(const motionField& f)
{
    return magSqr(f.v[0]) + sqr(w)*magSqr(f.D[0]);
}


//- A step by one Newton correction, which the linear equation needs
void step(const feTimeScheme& ts, motionField& f)
{
    f.D0 = f.D;
    f.v0 = f.v;
    f.a0 = f.a;
    f.predict(ts);

    vectorField Ds(1), vs(1), as(1);
    f.stage(ts, Ds, vs, as);
    const scalar tangent = ts.accelerationByUnknown() + sqr(w)*ts.displacementByUnknown();
    f.add(ts, 0, -(as[0] + sqr(w)*Ds[0])/tangent);

    f.stage(ts, Ds, vs, as);
    EXPECT_NEAR(0, mag(as[0] + sqr(w)*Ds[0]), 1e-12);
}


//- Ratio of the energies after and before each of three steps
List<scalar> ratios(const char* dict, const vector& a)
{
    auto ts = feTimeScheme::New(dictionary(IStringStream(dict)()));
    ts->setDeltaT(dt);

    motionField f(1);
    f.D[0] = vector(1, 0, 0);
    f.v[0] = vector(0.5, 0, 0);
    f.a[0] = a;

    List<scalar> r(3);
    for (scalar& x : r)
    {
        const scalar before = energy(f);
        step(ts(), f);
        x = energy(f)/before;
    }
    return r;
}

} // End anonymous namespace


TEST(timeSchemes, theTrapezoidalRuleKeepsTheEnergy)
{
    for (const scalar r : ratios("type Newmark;", vector(-sqr(w), 0, 0)))
    {
        EXPECT_NEAR(1, r, 1e-12);
    }
}


// (1 + i w dt)^-1 is its factor of amplification, which no start of the
// acceleration changes
TEST(timeSchemes, EulerIsBackwardEulerForASolid)
{
    for (const scalar r : ratios("type Euler;", vector(7, 0, 0)))
    {
        EXPECT_NEAR(1/(1 + sqr(w*dt)), r, 1e-12);
    }
}


// ************************************************************************* //

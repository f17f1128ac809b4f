/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Sizes of steps: by the number of iterations, the error, the times to meet,
    and after failures.
\*---------------------------------------------------------------------------*/

#include "stepControl.H"
#include "IStringStream.H"
#include <gtest/gtest.h>

namespace Foam
{

class steps : public ::testing::Test
{
protected:

    autoPtr<Time> time;
    autoPtr<stepControl> step;

    //- Steps made: their ends
    scalarList ends;

    void start(const std::string& control, const std::string& solution)
    {
        IStringStream is
        (
            "startFrom startTime; startTime 0; stopAt endTime; timePrecision 12; " + control
        );
        step.clear();
        time.reset(new Time(dictionary(is), "/tmp", "noCase", "system", "constant", false, false));
        IStringStream entries("timeStepControl { " + solution + " }");
        step.reset(new stepControl(time(), dictionary(entries)));
    }

    //- All steps of n(deltaT) iterations, 0: it fails
    template<class N>
    void run(const N& n, const scalar error = 0)
    {
        while (step->next())
        {
            while (step->attempt())
            {
                const label iterations = n(time->deltaTValue());
                if (iterations) step->accept(iterations, error);
                else step->bisect("diverged", "somewhere", true);
            }
            if (step->failed()) return;
            ends.append(time->value());
        }
    }

    void TearDown() override
    {
        step.clear();
        time.clear();
    }

    bool ended(const scalar t) const
    {
        for (const scalar end : ends) if (end == t) return true;
        return false;
    }
};


TEST_F(steps, areDeltaTWithoutAControl)
{
    start("deltaT 0.1; endTime 1; writeControl timeStep; writeInterval 1;", "");
    run([](scalar) { return 7; });
    EXPECT_EQ(ends.size(), 10);
    EXPECT_DOUBLE_EQ(ends.last(), 1);
}


TEST_F(steps, followTheNumberOfIterations)
{
    const std::string control = "deltaT 0.01; endTime 100; writeControl timeStep; writeInterval 1;";
    start(control, "type automatic; maxDeltaT 1; targetIterations 6;");
    const auto sizeAfter = [&](const label n)
    {
        step->next();
        step->attempt();
        step->accept(n, 0);
        step->next();
        step->attempt();
        return time->deltaTValue();
    };
    EXPECT_DOUBLE_EQ(sizeAfter(5), 0.012);
    EXPECT_DOUBLE_EQ(sizeAfter(12), 0.006);
    EXPECT_DOUBLE_EQ(sizeAfter(1), 0.009);
}


TEST_F(steps, stayBetweenTheirBounds)
{
    const std::string control = "deltaT 0.01; endTime 3; writeControl timeStep; writeInterval 1;";
    scalar least = GREAT, most = 0;
    const auto count = [&](const label n)
    {
        return [&, n](const scalar dt)
        {
            least = min(least, dt);
            most = max(most, dt);
            return n;
        };
    };
    start(control, "type automatic; maxDeltaT 0.05; minDeltaT 0.004;");
    run(count(1));
    EXPECT_DOUBLE_EQ(most, 0.05);
    start(control, "type automatic; maxDeltaT 0.05; minDeltaT 0.004;");
    run(count(20));
    EXPECT_LE(least, 0.004);
    EXPECT_GE(least, 0.002);    // half of the rest at the end
}


TEST_F(steps, followTheError)
{
    start
    (
        "deltaT 0.01; endTime 1; writeControl timeStep; writeInterval 1;",
        "type automatic; maxDeltaT 1; errorTolerance 1e-4;"
    );
    const auto size = [&](const scalar error)
    {
        step->next();
        step->attempt();
        step->accept(2, error);
        step->next();
        step->attempt();
        return time->deltaTValue();
    };
    EXPECT_DOUBLE_EQ(size(2.25e-4), 0.006);
    EXPECT_DOUBLE_EQ(size(1), 0.003);   // half at the most
}


TEST_F(steps, meetTimesAndKeepTheirSize)
{
    start
    (
        "deltaT 0.03; endTime 1; writeControl adjustableRunTime; writeInterval 0.25;",
        "type automatic; maxDeltaT 0.03; times (0.71 0.1);"
    );
    label nWritten = 0, nWhole = 0;
    const auto n = [&](const scalar dt)
    {
        nWritten += time->writeTime();
        nWhole += mag(dt - 0.03) < 1e-12;
        EXPECT_GE(dt, 0.0099);
        return 3;
    };
    run(n);
    for (const scalar t : {0.1, 0.25, 0.5, 0.71, 0.75, 1.0}) EXPECT_TRUE(ended(t)) << t;
    EXPECT_EQ(nWritten, 4);
    EXPECT_GT(nWhole, ends.size()/2);
}


TEST_F(steps, thatFailAreDividedAndKeepPace)
{
    start("deltaT 0.1; endTime 1; writeControl runTime; writeInterval 0.5;", "");
    label nFailed = 0, nWritten = 0;
    const auto n = [&](const scalar dt) -> label
    {
        const scalar t = time->value();
        const bool rough = t > 0.4 && t < 0.65;
        if (!(rough && dt > 0.03)) return 3;
        ++nFailed;
        return 0;
    };
    while (step->next())
    {
        while (step->attempt())
        {
            n(time->deltaTValue()) ? step->accept(3, 0) : step->bisect("diverged", "", true);
        }
        ends.append(time->value());
        nWritten += time->writeTime();
    }
    EXPECT_GT(nFailed, 1);
    for (label i = 1; i <= 10; ++i)
    {
        bool found = false;
        for (const scalar end : ends) found = found || mag(end - 0.1*i) < 1e-12;
        EXPECT_TRUE(found) << i;
    }
    EXPECT_EQ(nWritten, 2);
    EXPECT_EQ(time->timeIndex(), ends.size());
}


TEST_F(steps, endAtTheSmallest)
{
    start("deltaT 0.1; endTime 1; writeControl timeStep; writeInterval 1;", "minDeltaT 0.03;");
    run([&](const scalar) { return time->value() > 0.36 ? 0 : 3; });
    EXPECT_TRUE(step->failed());
    EXPECT_EQ(ends.size(), 4);      // 0.1, 0.2, 0.3, 0.35
    EXPECT_EQ(time->timeIndex(), 4);
    EXPECT_NE(step->failure().find("less than minDeltaT 0.03"), std::string::npos);
    EXPECT_NE(step->failure().find("somewhere"), std::string::npos);
}


TEST_F(steps, areNotDividedWhereThatIsOfNoUse)
{
    start("deltaT 0.1; endTime 1; writeControl timeStep; writeInterval 1;", "");
    step->next();
    step->attempt();
    step->bisect("singular", "", false);
    EXPECT_TRUE(step->failed());
    EXPECT_EQ(time->value(), 0);
    EXPECT_NE(step->failure().find("would not help"), std::string::npos);
}

} // End namespace Foam


// ************************************************************************* //

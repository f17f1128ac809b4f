/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Application
    test-system-tangent

Description
    The tangent of the coupled system, the mesh's motion included, against
    central differences of its residual in random directions, for the case of
    tests/resources/fsiPatch; and store() and restore(). On any number of ranks:

        test-system-tangent
        mpirun -np 2 test-system-tangent -parallel
\*---------------------------------------------------------------------------*/

#include "Time.H"
#include "runOnRanks.H"
#include "coupledSystem.H"
#include "Random.H"
#include "OSspecific.H"
#include "OStringStream.H"
#include <cstdlib>

using namespace Foam;

namespace
{

struct variant
{
    const char* name;
    std::vector<const char*> options;
};

const variant variants[] =
{
    {"taylorHoodSteady", {"time=type steady;"}},
    {"taylorHoodNewmark", {"time=type Newmark; gamma 0.6;"}},
    {"taylorHoodGeneralisedAlpha", {"time=type generalisedAlpha; rhoInf 0.5;"}},
    {"taylorHoodMetric", {"time=type generalisedAlpha; rhoInf 0.8;", "fluid=taylorHood; stabilisation metric"}},
    {"equalOrderSteady", {"time=type steady;", "fluid=equalOrder", "solid=enhancedStrain"}},
    {"equalOrderNewmark", {"time=type Newmark;", "fluid=equalOrder", "solid=linear"}},
    {"equalOrderGeneralisedAlpha", {"time=type generalisedAlpha; rhoInf 0.5;", "fluid=equalOrder", "solid=enhancedStrain"}},
    {
        "barotropic",
        {
            "time=type generalisedAlpha; rhoInf 0.5;", "fluid=equalOrder", "solid=linear",
            "transport=bulkModulus [1 -1 -2 0 0 0 0] 5;"
        }
    },
    {"space", {"time=type generalisedAlpha; rhoInf 0.5;", "fluid=equalOrder", "solid=linear", "dim=3"}},
    {"spaceTaylorHood", {"time=type Newmark;", "dim=3"}},
    {"spaceSteady", {"time=type steady;", "dim=3", "fluid=equalOrder", "solid=linear"}},
};

std::ostream& operator<<(std::ostream& os, const variant& v) { return os << v.name; }


class systemTangent : public ::testing::TestWithParam<variant>
{
    fileName dir_;
    autoPtr<Time> time_;
    Foam::Random random_{Pstream::myProcNo() + 1};

protected:

    autoPtr<coupledSystem> system;

    void SetUp() override
    {
        std::string name = "/tmp/test-system-XXXXXX";
        if (Pstream::master())
        {
            dir_ = ::mkdtemp(&name[0]);
            std::string make = getEnv("MONOLITHICFOAM_DIR") + "/tests/resources/fsiPatch " + dir_
                + " ranks=" + std::to_string(Pstream::nProcs());
            for (const char* option : GetParam().options) make += std::string(" '") + option + "'";
            if (std::system(make.c_str())) FatalErrorInFunction << make.c_str() << exit(FatalError);
        }
        Pstream::scatter(dir_);
        fileName caseName(dir_.name());
        if (Pstream::parRun()) caseName = caseName/("processor" + Foam::name(Pstream::myProcNo()));
        time_.reset(new Time(Time::controlDictName, fileName(dir_.path()), caseName));
        system.reset(new coupledSystem(time_()));
    }

    void TearDown() override
    {
        system.clear();
        time_.clear();
        label done = 1;
        reduce(done, sumOp<label>());
        if (Pstream::master()) rmDir(dir_);
    }

    bool steady() const { return system->regions()[0].timeScheme().steady(); }

    //- Random increment that obeys the constraints. Displacements are small,
    //  so that no element is inverted
    scalarField increment(const scalar scale)
    {
        const nodeMap& map = system->map();
        scalarField dx(map.nUnknowns());
        for (scalar& s : dx) s = scale*random_.GaussNormal<scalar>();

        // An unknown that any rank knows as a solid's is a displacement of a
        // steady case
        scalarField solid(map.nUnknowns(), 0);
        for (feRegion& region : system->regions())
        {
            if (!region.interfaceMotion() || !steady()) continue;
            for (const label n : region.systemNode()) for (label a = 0; a < region.fe().dim(); ++a)
            {
                solid[map.start(n) + a] = 1;
            }
        }
        map.maximum(solid);
        forAll(dx, u) if (solid[u] > 0) dx[u] *= 0.1;

        map.fromOwner(dx);
        system->constraints().distribute(dx);
        return dx;
    }

    //- A random state, of a step from another one
    void randomise()
    {
        system->increment(increment(0.1));
        next();
        system->increment(increment(0.1));
    }

    void next()
    {
        system->store();
        ++time_();
        for (feRegion& region : system->regions())
        {
            region.timeScheme().setDeltaT(time_->deltaTValue());
            region.predict(time_->value());
        }
    }

    //- Assembled at the present state; free rows
    scalarField residual()
    {
        system->linearise();
        scalarField R(system->residual());
        forAll(R, u) if (!system->constraints().isFree(u)) R[u] = 0;
        return R;
    }

    //- State of all regions, as text of all digits
    std::string state()
    {
        OStringStream os(IOstream::BINARY);
        for (feRegion& region : system->regions()) region.state().write(os);
        return os.str();
    }

    scalar norm(const scalarField& x, const scalarField& rows) const
    {
        return ::sqrt(system->map().dot(scalarField(x*rows), scalarField(x*rows)));
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

//- All copies of an unknown are free, fixed or tied alike
TEST_P(systemTangent, constraintsAgreeOverTheRanks)
{
    const nodeMap& map = system->map();
    const dofConstraints& c = system->constraints();
    scalarField kind(map.nUnknowns());
    forAll(kind, u) kind[u] = c.isFree(u) ? 0 : c.isFixed(u) ? 1 : 1 + c.masters(u).size();
    scalarField largest(kind), smallest(-kind);
    map.maximum(largest);
    map.maximum(smallest);
    forAll(kind, u) EXPECT_EQ(largest[u], -smallest[u]) << u;
}


TEST_P(systemTangent, isTheDerivativeOfTheResidual)
{
    randomise();
    const nodeMap& map = system->map();
    const label n = map.nUnknowns();

    // Equations of momentum and of continuity (after the components)
    scalarField momentum(n, 1), continuity(n, 0);
    for (const feRegion& region : system->regions())
    {
        const label dim = region.fe().dim();
        for (const label node : region.systemNode())
        {
            if (map.nUnknowns(node) <= dim) continue;
            momentum[map.start(node) + dim] = 0;
            continuity[map.start(node) + dim] = 1;
        }
    }

    for (label direction = 0; direction < 3; ++direction)
    {
        residual();
        for (const feRegion& region : system->regions()) ASSERT_GT(region.minDetJ(), 0);
        const scalarField dx(increment(1));
        scalarField y(n, 0), dR(n);
        system->tangentAction(dx, y);

        const scalar h = 1e-6;
        system->increment(h*dx);
        dR = residual();
        system->increment(-2*h*dx);
        dR = (dR - residual())/(2*h);
        system->increment(h*dx);

        for (const scalarField* rows : {&momentum, &continuity})
        {
            const scalar size = norm(y, *rows);
            EXPECT_GT(size, 0);
            EXPECT_LT(norm(y - dR, *rows), 1e-6*size) << (rows == &momentum ? "momentum" : "continuity");
        }
    }
}


TEST_P(systemTangent, restoresItsState)
{
    randomise();
    next();
    system->restore();
    const std::string before = state();
    const scalarField R(residual());

    system->store();
    system->increment(increment(0.1));
    EXPECT_NE(state(), before);
    residual();
    system->increment(increment(0.1));
    EXPECT_FALSE(R == residual());

    system->restore();
    EXPECT_EQ(state(), before);
    EXPECT_TRUE(R == residual());
}


//- Whole steps: from the restored state the same one again
TEST_P(systemTangent, repeatsAStep)
{
    next();
    const bool ok = system->step();
    const std::string after = state();
    EXPECT_TRUE(ok);
    system->restore();
    EXPECT_NE(state(), after);
    system->writeState();   // drops the factors
    system->step();
    EXPECT_TRUE(Pstream::parRun() || state() == after);
}


INSTANTIATE_TEST_SUITE_P
(
    variants, systemTangent, ::testing::ValuesIn(variants),
    [](const auto& info) { return std::string(info.param.name); }
);


int main(int argc, char* argv[]) { return Foam::runOnRanks(argc, argv); }


// ************************************************************************* //

/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Application
    test-system-tangent

Description
    The tangent of the coupled system, the mesh's motion included, against
    central differences of its residual in random directions, for the case of
    tests/resources/fsiPatch; and what its state does when steps are undone or
    the discretisation is made anew, also in FSI3. On any number of ranks:

        test-system-tangent
        mpirun -np 2 test-system-tangent -parallel
\*---------------------------------------------------------------------------*/

#include "Time.H"
#include "runOnRanks.H"
#include "decomposedCase.H"
#include "coupledSystem.H"
#include "meshExchange.H"
#include "Random.H"
#include "OSspecific.H"
#include "ListOps.H"
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>

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
    {"taylorHoodGeneralisedAlpha", {"time=type generalisedAlpha; rhoInf 0.5;", "opening=type zeroGradient;"}},
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
    {
        "mixedTaylorHood",
        {"time=type generalisedAlpha; rhoInf 0.5;", "solid=taylorHood", "material=type MooneyRivlin; rho 2; c1 4; c2 2;"}
    },
    {
        "mixedQ1Q0",
        {
            "time=type generalisedAlpha; rhoInf 0.8;", "fluid=equalOrder", "solid=Q1Q0",
            "material=type isochoricNeoHookean; rho 2; mu 12;"
        }
    },
    {
        "mixedEqualOrderSteady",
        {
            "time=type steady;", "fluid=equalOrder", "solid=equalOrder",
            "material=type isochoricNeoHookean; rho 2; mu 12; bulkModulus 500;"
        }
    },
    {
        "space",
        {
            "time=type generalisedAlpha; rhoInf 0.5;", "fluid=equalOrder", "solid=linear", "dim=3",
            "root=type rigidContact; penalty 10; surface { type sphere; centre (0.5 -3.3 0.25); radius 3; }",
            "opening=type zeroGradient;"
        }
    },
    {"spaceTaylorHood", {"time=type Newmark;", "dim=3"}},
    {
        "rigidRoot",
        {
            "time=type generalisedAlpha; rhoInf 0.5;",
            "root=type rigidPatch; translation { x { force 0; } y { force 1; } } rotation { z { moment 0.3; } }"
            " mass 0.5; inertia (0.1 0 0 0.1 0 0.1);"
        }
    },
    {"spaceSteady", {"time=type steady;", "dim=3", "fluid=equalOrder", "solid=linear"}},
    {
        "nonMatchingSteady",
        {"time=type steady;", "interface=type nonMatching;", "sx=5", "fluid=equalOrder"}
    },
    {
        "nonMatchingSpace",
        {
            "time=type generalisedAlpha; rhoInf 0.5;", "interface=type nonMatching;", "dim=3",
            "fluid=equalOrder", "sx=3", "nx=4", "wet=1,0.09 0,-0.02"
        }
    },
};

//- Cases as fsiPatch makes them, once for all tests that want the same
class patchCases
{
    std::map<std::string, std::string> made_;

public:

    ~patchCases() { for (const auto& c : made_) std::filesystem::remove_all(c.second); }

    void copy(const std::string& options, const std::string& to)
    {
        std::string& from = made_[options];
        if (from.empty())
        {
            from = to + ".made";
            for (int n = 0; std::filesystem::exists(from); ++n) from = to + ".made" + std::to_string(n);
            const std::string make = getEnv("MONOLITHICFOAM_DIR") + "/tests/resources/fsiPatch " + from + options;
            if (std::system(make.c_str())) FatalErrorInFunction << make.c_str() << exit(FatalError);
        }
        std::filesystem::remove_all(to);
        std::filesystem::copy
        (
            from, to, std::filesystem::copy_options::recursive | std::filesystem::copy_options::copy_symlinks
        );
    }
};

std::ostream& operator<<(std::ostream& os, const variant& v) { return os << v.name; }


class systemTangent : public ::testing::TestWithParam<variant>
{
    fileName dir_;
    Foam::Random random_{Pstream::myProcNo() + 1};

protected:

    autoPtr<Time> time;
    autoPtr<coupledSystem> system;

    void SetUp() override
    {
        std::string name = "/tmp/test-system-XXXXXX";
        if (Pstream::master())
        {
            dir_ = ::mkdtemp(&name[0]);
            make({});
        }
        Pstream::scatter(dir_);
        start();
    }

    //- The case, of the variant and further options
    void make(const std::vector<const char*>& further)
    {
        static patchCases cases;
        system.clear();
        std::string all = " ranks=" + std::to_string(Pstream::nProcs());
        for (const auto& options : {GetParam().options, further}) for (const char* option : options)
        {
            all += std::string(" '") + option + "'";
        }
        cases.copy(all, dir_);
    }

    //- The case from its beginning
    void start()
    {
        system.clear();
        fileName caseName(dir_.name());
        if (Pstream::parRun()) caseName = caseName/("processor" + Foam::name(Pstream::myProcNo()));
        time.reset(new Time(Time::controlDictName, fileName(dir_.path()), caseName));
        system.reset(new coupledSystem(time()));
    }

    void TearDown() override
    {
        system.clear();
        time.clear();
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
        for (const feRegion& region : system->regions())
        {
            if (!region.leads() || !steady()) continue;
            for (label n = 0; n < region.fe().nNodes(); ++n) for (label a = 0; a < region.fe().dim(); ++a)
            {
                solid[region.unknowns().start(0, n) + a] = 1;
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
        ++time();
        for (feRegion& region : system->regions())
        {
            region.timeScheme().setDeltaT(time->deltaTValue());
            region.predict(time->value());
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

    //- A step, as the application does it
    void step(const scalar deltaT = 0.1)
    {
        system->store();
        time->setDeltaT(deltaT, false);
        ++time();
        EXPECT_TRUE(system->step());
    }

    //- The mesh of a region in other numbers of points and cells
    meshExchange renumbered(const fvMesh& mesh, const bool shuffle)
    {
        meshExchange e;
        e.pointMap = identity(mesh.nPoints());
        e.cellMap = identity(mesh.nCells());
        e.faceMap = identity(mesh.nFaces());
        if (shuffle)
        {
            random_.shuffle(e.pointMap);
            random_.shuffle(e.cellMap);
        }
        const labelList newPoint(invert(mesh.nPoints(), e.pointMap));
        const labelList newCell(invert(mesh.nCells(), e.cellMap));

        // Internal faces in the order of their cells, which they point away from
        const auto cells = [&](const label f)
        {
            const label a = newCell[mesh.faceOwner()[f]], b = newCell[mesh.faceNeighbour()[f]];
            return labelPair(min(a, b), max(a, b));
        };
        std::sort
        (
            e.faceMap.begin(), e.faceMap.begin() + mesh.nInternalFaces(),
            [&](const label f, const label g) { return cells(f) < cells(g); }
        );
        e.points = pointField(mesh.points(), e.pointMap);
        for (const label f : e.faceMap)
        {
            face now(renumber(newPoint, mesh.faces()[f]));
            const bool internal = mesh.isInternalFace(f);
            if (internal && cells(f).first() != newCell[mesh.faceOwner()[f]]) now.flip();
            e.faces.append(now);
            e.owner.append(internal ? cells(f).first() : newCell[mesh.faceOwner()[f]]);
            if (internal) e.neighbour.append(cells(f).second());
        }
        for (const polyPatch& p : mesh.boundaryMesh())
        {
            e.patchSizes.append(p.size());
            e.patchStarts.append(p.start());
        }
        return e;
    }

    static labelList nearest(const pointField& to, const pointField& from)
    {
        labelList map(to.size());
        forAll(to, i)
        {
            map[i] = 0;
            forAll(from, k) if (magSqr(from[k] - to[i]) < magSqr(from[map[i]] - to[i])) map[i] = k;
        }
        return map;
    }

    static pointField faceCentres(const pointField& points, const faceList& faces)
    {
        pointField c(faces.size());
        forAll(c, f) c[f] = faces[f].centre(points);
        return c;
    }

    //- New meshes for all regions between two steps; the state of the nearest nodes
    template<class Make>
    void exchangeMeshes(PtrList<stateMap>& maps, const Make& make)
    {
        maps.clear();
        const auto at = [](const feRegion& region)
        {
            return pointField(region.fe().points() + (region.leads() ? 0 : 1)*region.motion().D);
        };
        List<const stateMap*> given;
        for (feRegion& region : system->regions())
        {
            region.advance();
            const pointField nodes(at(region));
            const pointField vertices(SubField<point>(nodes, region.fe().nVertices()));
            const pointField cells(region.mesh().cellCentres());
            meshExchange e(make(region.mesh()));
            e.apply(region.mesh());

            // Of a solid, the mesh is the reference; there are no other nodes
            // than those of the new elements
            maps.append(new stateMap);
            stateMap& m = maps.last();
            m.points0 = region.mesh().points();
            const feMesh fe(region.mesh(), region.fe().order(), dictionary(), m.points0);
            const auto set = [](valueMap& map, const labelList& from)
            {
                for (const label k : from)
                {
                    map.from.append(labelList(1, k));
                    map.weight.append(scalarList(1, 1.0));
                }
            };
            set(m.nodes, nearest(fe.points(), nodes));
            set(m.vertices, nearest(SubField<point>(fe.points(), fe.nVertices()), vertices));
            set(m.cells, nearest(region.mesh().cellCentres(), cells));
            given.append(&m);
        }
        system->discretise(given);
    }

    //- All numbers of the state of all regions
    List<scalarList> state()
    {
        List<scalarList> all;
        for (feRegion& region : system->regions()) all.append(region.state().copy());
        return all;
    }

    //- Lists of the end of a step, the components one after the other
    std::map<std::string, scalarField> lists()
    {
        std::map<std::string, scalarField> all;
        for (feRegion& region : system->regions()) for (const statePart& part : region.state().parts())
        {
            const std::string name = region.name() + '.';
            const auto scalars(part.scalars());
            forAllConstIters(scalars, iter) all[name + iter.key()] = *iter.val();
            const auto vectors(part.vectors());
            forAllConstIters(vectors, iter) for (direction c = 0; c < 3; ++c)
            {
                all[name + iter.key()].append(iter.val()->component(c)());
            }
        }
        return all;
    }

    //- The present state is that of before: to the bit on one rank, each list
    //  relative to the largest of its values on several
    void expectState
    (
        const List<scalarList>& bits,
        const std::map<std::string, scalarField>& before,
        const scalar tolerance
    )
    {
        if (!Pstream::parRun())
        {
            EXPECT_TRUE(state() == bits);
            return;
        }
        const auto now = lists();
        EXPECT_EQ(now.size(), before.size());
        for (const auto& list : before)
        {
            const scalarField difference(list.second - now.at(list.first));
            const scalar size = gMax(mag(list.second)());
            EXPECT_LE(gMax(mag(difference)()), tolerance*size) << list.first;
        }
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
    forAll(kind, u) kind[u] = c.isFree(u) ? 0 : c.isTied(u) && !c.isFixed(u) ? 1 + c.masters(u).size() : 1;
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

    // Equations of momentum and of continuity, as any rank knows them
    scalarField continuity(n, 0);
    for (const feRegion& region : system->regions()) for (label f = 1; f < region.layout().nFields(); ++f)
    {
        for (label i = 0; i < region.layout().size(f); ++i) continuity[region.unknowns().start(f, i)] = 1;
    }
    map.maximum(continuity);
    scalarField momentum(1 - continuity);

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
    const List<scalarList> before(state());
    const scalarField R(residual());

    system->store();
    system->increment(increment(0.1));
    EXPECT_FALSE(state() == before);
    residual();
    system->increment(increment(0.1));
    EXPECT_FALSE(R == residual());

    system->restore();
    EXPECT_TRUE(state() == before);
    EXPECT_TRUE(R == residual());
}


//- Whole steps: from the restored state the same one again, the first one
//  without factors at its start and one with those of a step before
TEST_P(systemTangent, repeatsAStep)
{
    for (const label index : {1, 2})
    {
        SCOPED_TRACE(index);
        step();
        EXPECT_EQ(time->timeIndex(), index);
        const List<scalarList> after(state());
        const auto afterLists = lists();
        system->restore();
        EXPECT_EQ(time->timeIndex(), index - 1);
        EXPECT_FALSE(state() == after);
        system->writeState();   // changes nothing
        step();
        expectState(after, afterLists, 1e-10);
    }
}


//- An attempt that was undone leaves no trace in shorter steps
TEST_P(systemTangent, halvesAStep)
{
    const scalar deltaT = 0.1;
    step(deltaT/2);
    step(deltaT/2);
    const List<scalarList> straight(state());
    const auto straightLists = lists();

    start();
    step(deltaT);
    EXPECT_TRUE(steady() || !(state() == straight));
    system->restore();
    EXPECT_EQ(time->value(), 0);
    step(deltaT/2);
    step(deltaT/2);
    EXPECT_EQ(time->timeIndex(), 2);
    expectState(straight, straightLists, 1e-10);
}


//- On the same mesh, between two steps
TEST_P(systemTangent, isDiscretisedAnew)
{
    step();
    step();
    const List<scalarList> straight(state());
    const auto straightLists = lists();

    start();
    step();
    const List<scalarList> before(state());
    system->discretise();
    EXPECT_TRUE(state() == before);
    step();
    expectState(straight, straightLists, 1e-12);
}


//- Other numbers of points and cells, on any number of ranks
TEST_P(systemTangent, isDiscretisedOnARenumberedMesh)
{
    const auto afterExchange = [&](const bool renumber, PtrList<stateMap>& maps)
    {
        start();
        step();
        exchangeMeshes(maps, [&](const fvMesh& mesh) { return renumbered(mesh, renumber); });
        step();
        step();
        return lists();
    };
    PtrList<stateMap> same, maps;
    const auto straight = afterExchange(false, same);
    const auto renumbered = afterExchange(true, maps);

    EXPECT_EQ(straight.size(), renumbered.size());
    forAll(system->regions(), r)
    {
        feRegion& region = system->regions()[r];
        for (const statePart& part : region.state().parts())
        {
            const valueMap& map = maps[r].at(part.on());
            const auto scalars(part.scalars());
            const auto vectors(part.vectors());
            const label n = map.from.size();
            const auto expect = [&](const word& name, const label nCmpts)
            {
                const scalarField& a = straight.at(region.name() + '.' + name);
                const scalarField& b = renumbered.at(region.name() + '.' + name);
                ASSERT_EQ(a.size(), b.size());
                if (b.size() != nCmpts*n) return;   // of no use in this case
                scalar worst = 0;
                for (label c = 0; c < nCmpts; ++c) for (label i = 0; i < n; ++i)
                {
                    worst = max(worst, mag(b[c*n + i] - a[c*n + map.from[i][0]]));
                }
                EXPECT_LE(returnReduce(worst, maxOp<scalar>()), 1e-9*gMax(mag(a)()) + 1e-15) << name;
            };
            forAllConstIters(scalars, iter) expect(iter.key(), 1);
            forAllConstIters(vectors, iter) expect(iter.key(), 3);
        }
    }
}


//- With more cells: as if the case had had them from the beginning
TEST_P(systemTangent, isDiscretisedOnAFinerMesh)
{
    if (Pstream::parRun()) return;
    make({"nx=3", "ny=5"});
    start();
    const label nUnknowns = system->unknowns().nFree();
    PtrList<meshExchange> finer;
    for (const feRegion& region : system->regions())
    {
        finer.append(new meshExchange(renumbered(region.mesh(), false)));
    }
    step();
    step();
    const auto straight = lists();

    make({});
    start();
    EXPECT_LT(system->unknowns().nFree(), nUnknowns);
    PtrList<stateMap> maps;
    label r = 0;
    exchangeMeshes(maps, [&](const fvMesh& mesh)
    {
        meshExchange& e = finer[r++];
        e.pointMap = nearest(e.points, mesh.points());
        e.faceMap = nearest(faceCentres(e.points, e.faces), mesh.faceCentres());
        e.cellMap = labelList(max(e.owner) + 1, 0);
        return e;
    });
    EXPECT_EQ(system->unknowns().nFree(), nUnknowns);
    step();
    step();
    const auto now = lists();
    for (const auto& list : straight)
    {
        ASSERT_EQ(list.second.size(), now.at(list.first).size());
        EXPECT_LE(gMax(mag(list.second - now.at(list.first))()), 1e-9*gMax(mag(list.second)()) + 1e-15) << list.first;
    }
}


//- In the middle of FSI3, with kept factors: not a bit
TEST(fsi3Short, isDiscretisedAnew)
{
    if (Pstream::parRun()) return;
    decomposedCase fsi3("fsi3Short", "");
    const auto states = [&](const bool anew)
    {
        Time time(Time::controlDictName, fileName(fsi3.dir.path()), fileName(fsi3.dir.name()));
        coupledSystem system(time);
        for (label i = 0; i < 8; ++i)
        {
            system.store();
            ++time;
            EXPECT_TRUE(system.step());
            system.advance();
            if (anew && i % 3 == 1) system.discretise();
        }
        List<scalarList> all;
        for (feRegion& region : system.regions()) all.append(region.state().copy());
        return all;
    };
    const List<scalarList> straight(states(false));
    EXPECT_GT(gMax(mag(straight[0])()), 0);
    EXPECT_TRUE(straight == states(true));
}


//- Where the two surfaces have gaps: as the solid turns and stretches, the fluid's
//  nodes are where its points would be
class nonMatchingMotion : public systemTangent {};

TEST_P(nonMatchingMotion, isThatOfTheBody)
{
    feInterface& interface = const_cast<feInterface&>(system->interfaces()[0]);
    const scalar angle = 1.8;
    const scalar c = ::cos(angle), s = ::sin(angle);
    const tensor R(c, -s, 0, s, c, 0, 0, 0, 1);
    const tensor F = R & tensor(1.2, 0.3, 0, 0, 0.9, 0, 0, 0, 1), L(0, -2, 0, 3, 0.5, 0, 0, 0, 0);
    const point centre(0.3, -0.2, 0.1);

    motionField& solid = interface.leader().motion();
    const vectorField& Xs = interface.leader().fe().points();
    forAll(Xs, n)
    {
        solid.D[n] = (F - tensor::I) & (Xs[n] - centre);
        solid.v[n] = L & (Xs[n] - centre);
    }
    interface.follow();
    const motionField& fluid = interface.follower().motion();
    for (const label n : interface.followerNodes())
    {
        const vector X = interface.follower().fe().points()[n] - centre;
        EXPECT_LT(mag(fluid.D[n] - ((F - tensor::I) & X)), 1e-12);
        EXPECT_LT(mag(fluid.v[n] - (L & X)), 1e-12);
    }
}

INSTANTIATE_TEST_SUITE_P
(
    variants, nonMatchingMotion, ::testing::Values
    (
        variant{"plane", {"interface=type nonMatching;", "sx=3", "wet=1,0.08 0,-0.02"}},
        variant{"planeMortar", {"interface=type nonMatching; weights mortar;", "sx=5", "wet=1,0.08 0,0.02"}},
        variant
        {
            "spaceMortar",
            {"interface=type nonMatching; weights mortar;", "dim=3", "sx=3", "fluid=equalOrder", "wet=1,0.08 0,-0.02"}
        }
    ),
    [](const auto& info) { return std::string(info.param.name); }
);

INSTANTIATE_TEST_SUITE_P
(
    variants, systemTangent, ::testing::ValuesIn(variants),
    [](const auto& info) { return std::string(info.param.name); }
);


int main(int argc, char* argv[]) { return Foam::runOnRanks(argc, argv); }


// ************************************************************************* //

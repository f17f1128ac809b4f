/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Application
    feMapFields

Description
    The state of another case on the meshes of this one, which a run of this case
    then starts from: velocities, pressures, displacements, their rates and what
    has a history, at all nodes, mid-side ones included.

        feMapFields [-sourceTime <time>] [-region <name>] [-method <mapping>]
            [-tolerance <part>] <sourceCase>

    -sourceTime default: the latest
    -region     default: all regions, each from that of its name
    -method     interpolation, the default, or projection, which makes velocities
                continuous and finds the accelerations and pressures that go with
                them (interpolationMapping.H)
    -tolerance  default 0.1: of an element's size; a node farther outside of the
                source's mesh is an error, a nearer one has the value inside

    Nodes take the values of the place where they are in the references of both
    cases: a solid that is deformed stays so, and so does the mesh around it. The
    meshes must differ, the shapes at rest must not. Meshes of fluids follow the
    solids of this case. Elements may be of other kinds and orders; of what
    only one of the cases has, the log tells.

    Written to the time that the case starts from, with the state for a restart. On
    one rank; decomposePar carries the result.
\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "caseTime.H"
#include "coupledSystem.H"
#include "exitOnError.H"
#include "refuseBlanks.H"
#include "meshMapping.H"

using namespace Foam;

//- Time of the source, the latest one where none is asked for
static instant sourceTime(const Time& source, const argList& args)
{
    const instantList times(source.times());
    if (!args.found("sourceTime") || args["sourceTime"] == "latestTime") return times.last();
    const scalar wanted = args.get<scalar>("sourceTime");
    for (const instant& t : times)
    {
        if (t.name() != source.constant() && t.equal(wanted)) return t;
    }
    wordList names;
    for (const instant& t : times) if (t.name() != source.constant()) names.append(t.name());
    FatalErrorInFunction
        << "Case " << source.path() << " has no time " << args["sourceTime"].c_str() << ". Times: " << names
        << exit(FatalError);
    return instant();
}


//- The region of the other case with the name of one of this
static feRegion& sourceOf(const feRegion& region, coupledSystem& source)
{
    wordList names;
    for (feRegion& from : source.regions())
    {
        names.append(from.name());
        if (from.name() != region.name()) continue;
        if (from.type() == region.type() && from.fe().dim() == region.fe().dim()) return from;
        FatalErrorInFunction
            << "Region " << region.name() << " is " << region.type() << " in " << region.fe().dim()
            << "-D, and " << from.type() << " in " << from.fe().dim() << "-D in the case of the values"
            << exit(FatalError);
    }
    FatalErrorInFunction
        << "The case of the values has no region " << region.name() << ". Its regions: " << names << nl
        << "Choose others with -region" << exit(FatalError);
    return source.regions()[0];
}


//- Where the values of a region come from
static stateMap mapOf(const feRegion& from, const feRegion& to, const meshMapping& mapping)
{
    const elementSearch search(from.fe(), from.fe().points());
    const polyMesh& mesh = to.mesh();
    labelList cells(mesh.nCells(), -1);
    for (const elementBlock& block : to.fe().blocks()) for (label e = 0; e < block.size(); ++e)
    {
        point centre = Zero;
        for (label i = 0; i < block.nVertices(); ++i) centre += to.fe().points()[block.element(e)[i]]/block.nVertices();
        cells[block.cells[e]] = search.cell(search.find(centre, GREAT));
    }
    const labelList none(mesh.nPoints(), -1);
    stateMap map;
    const string failure
    (
        mapping.map({from.fe(), from.fe().points(), search, none, cells, boolList(cells.size(), true)}, to.fe(), map)
    );
    if (failure.empty()) return map;
    FatalErrorInFunction
        << "Region " << to.name() << ": " << failure.c_str() << nl
        << "The shapes at rest of both cases must be the same; or give a larger -tolerance" << exit(FatalError);
    return map;
}


template<class Type>
static void mapLists
(
    const HashTable<Field<Type>*>& from,
    const HashTable<Field<Type>*>& to,
    const valueMap* map,
    wordHashSet& mapped
)
{
    forAllConstIters(to, iter)
    {
        Field<Type>& list = *iter.val();
        if (!from.found(iter.key()) || list.empty()) continue;
        const Field<Type>& old = *from[iter.key()];
        if (old.empty() || (!map && old.size() != list.size())) continue;
        if (map) list = (*map)(old);
        else list = old;
        mapped.insert(iter.key());
    }
}


//- The state, list by list; what is not in both is told
static void mapState(feRegion& from, feRegion& to, const stateMap& map)
{
    wordHashSet mapped, all;
    const auto add = [&](const statePart& part)
    {
        const auto scalars(part.scalars());
        const auto vectors(part.vectors());
        forAllConstIters(scalars, iter) if (!iter.val()->empty()) all.insert(iter.key());
        forAllConstIters(vectors, iter) if (!iter.val()->empty()) all.insert(iter.key());
    };
    for (const statePart& part : from.state().parts()) add(part);
    for (const statePart& part : to.state().parts())
    {
        add(part);
        const valueMap* at = part.on() == fieldLayout::support::BODIES ? nullptr : &map.at(part.on());
        for (const statePart& old : from.state().parts())
        {
            if (old.name() != part.name() || old.on() != part.on()) continue;
            mapLists(old.scalars(), part.scalars(), at, mapped);
            mapLists(old.vectors(), part.vectors(), at, mapped);
        }
    }
    all -= mapped;
    Info<< "Region " << to.name() << ": " << flatOutput(mapped.sortedToc()) << nl;
    if (!all.empty()) Info<< "    only in one of the cases: " << flatOutput(all.sortedToc()) << nl;
}


// * * * * * * * * * * * * * * * * Main Program  * * * * * * * * * * * * * * //

int main(int argc, char *argv[])
{
    argList::addNote
    (
        "The state of another case at one of its times on the meshes of this case, for a run that starts from it"
    );
    argList::noParallel();
    argList::addArgument("sourceCase");
    argList::addOption("sourceTime", "time", "Time of the other case; default: the latest");
    argList::addOption("region", "name", "The region that is mapped; default: all");
    argList::addOption("method", "mapping", "interpolation (default) or projection, of the velocities onto continuity");
    argList::addOption
    (
        "tolerance", "part", "How far outside of the other mesh a node may be, in sizes of the elements; default 0.1"
    );
    refuseBlanks(argc, argv);
    #include "setRootCase.H"
    exitOnError();

    dictionary dict, coeffs;
    const word method(args.lookupOrDefault<word>("method", "interpolation"));
    dict.add("mapping", method);
    coeffs.add("tolerance", args.lookupOrDefault<scalar>("tolerance", 0.1));
    dict.add(word(method + "Coeffs"), coeffs);
    const autoPtr<meshMapping> mapping(meshMapping::New(dict));

    caseTime runTime(args);
    coupledSystem target(runTime);
    fileName sourceCase(args[1]);
    sourceCase.toAbsolute().clean();
    if (!isFile(sourceCase/"system"/"controlDict"))
    {
        FatalErrorInFunction << sourceCase << " is no case: it has no system/controlDict" << exit(FatalError);
    }
    Time source(Time::controlDictName, sourceCase.path(), fileName(sourceCase.name()));
    source.setTime(sourceTime(source, args), 0);
    Info<< "Values of " << sourceCase << " at time " << source.timeName() << nl << endl;
    coupledSystem values(source);

    label n = 0;
    for (feRegion& region : target.regions())
    {
        if (args.found("region") && region.name() != args["region"]) continue;
        feRegion& from = sourceOf(region, values);
        mapState(from, region, mapOf(from, region, mapping()));
        ++n;
    }
    if (!n) FatalErrorInFunction << "There is no region " << args["region"].c_str() << exit(FatalError);

    target.settle();
    if (mapping->projects() && target.projects() && !target.project())
    {
        FatalErrorInFunction
            << "The projection of the velocities has failed. " << target.outcome().c_str() << exit(FatalError);
    }
    target.advance();
    runTime.writeNow();
    runTime.complete();
    Info<< nl << "Written to time " << runTime.timeName() << nl << "End\n" << endl;
    return 0;
}


// ************************************************************************* //

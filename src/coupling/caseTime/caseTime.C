/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "caseTime.H"
#include "HashSet.H"
#include "OSspecific.H"
#include "Pstream.H"
#include "PstreamReduceOps.H"
#include <fstream>
#include <sys/statvfs.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

static const std::string writing("writing."), unfinished("unfinished.");


//- Directories of times are where the case says
static bool plainFiles() { return fileHandler().type() == "uncollated"; }


//- Less than a buffer of a file is left: the ends of some may be missing, which
//  streams do not tell when they are closed
static bool diskFull(const fileName& path)
{
    struct statvfs disk;
    return ::statvfs(path.c_str(), &disk) == 0 && scalar(disk.f_bavail)*disk.f_frsize < 65536;
}


//- Times that any rank has not finished
static wordList unfinishedTimes(const fileName& path)
{
    List<wordList> ofRanks(Pstream::nProcs());
    for (const fileName& name : readDir(path, fileName::FILE, false))
    {
        if (name.compare(0, writing.size(), writing) != 0) continue;
        ofRanks[Pstream::myProcNo()].append(word(name.substr(writing.size())));
    }
    Pstream::gatherList(ofRanks);
    Pstream::scatterList(ofRanks);
    wordHashSet all;
    for (const wordList& names : ofRanks) all.insert(names);
    return all.sortedToc();
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

const Foam::argList& Foam::caseTime::withoutUnfinished(const argList& args)
{
    if (!plainFiles()) return args;
    const fileName path(args.path());
    for (const word& time : unfinishedTimes(path))
    {
        const fileName from(path/time), to(path/(unfinished + time));
        if (isDir(from))
        {
            if (isDir(to)) rmDir(to);
            mv(from, to);
        }
        rm(path/(writing + time));
        WarningInFunction
            << "Time " << time << " was not written to its end, by a run that was ended"
            << " meanwhile." << nl
            << "    It is now " << unfinished.c_str() << time
            << ", which nobody reads and which may be removed" << endl;
    }
    return args;
}


void Foam::caseTime::mark() const
{
    if (!plainFiles()) return;
    marker_ = path()/(writing + timeName());
    const std::ofstream os(marker_);
    if (returnReduce(os.good(), andOp<bool>())) return;
    FatalErrorInFunction
        << "Could not write " << marker_ << ": is the disk full?" << exit(FatalError);
}


void Foam::caseTime::notWritten() const
{
    FatalErrorInFunction
        << "Time " << timeName() << " could not be written to its end in " << path()
        << ": is the disk full?" << nl
        << "The next run starts from the time before" << exit(FatalError);
}


void Foam::caseTime::purge() const
{
    if (!purgeWrite_) return;
    if (previousWriteTimes_.empty() || previousWriteTimes_.top() != timeName())
    {
        previousWriteTimes_.push(timeName());
    }
    while (previousWriteTimes_.size() > purgeWrite_)
    {
        fileHandler().rmDir
        (
            fileHandler().filePath(objectRegistry::path(previousWriteTimes_.pop()))
        );
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::caseTime::caseTime(const argList& args)
:
    Time(Time::controlDictName, withoutUnfinished(args))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::caseTime::run() const
{
    const bool more = Time::run();
    complete();
    return more;
}


bool Foam::caseTime::writeObject
(
    IOstream::streamFormat format,
    IOstream::versionNumber version,
    IOstream::compressionType compression,
    const bool valid
) const
{
    if (!writeTime()) return false;
    mark();
    bool ok = writeTimeDict();
    ok = objectRegistry::writeObject(format, version, compression, valid) && ok;
    if (!returnReduce(ok, andOp<bool>())) notWritten();
    return true;
}


void Foam::caseTime::complete() const
{
    if (marker_.empty()) return;
    if (returnReduce(diskFull(path()), orOp<bool>())) notWritten();
    rm(marker_);
    marker_.clear();
    purge();
}


// ************************************************************************* //

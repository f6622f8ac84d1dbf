package tompkins.app;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.EnumMap;
import java.util.Iterator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import tompkins.image.Fonts;
import tompkins.io.SelfDescription;
import tompkins.property.MistakeException;
import tompkins.studio.Studio;
import tompkins.study.Conclusion;
import tompkins.study.Measurement;
import tompkins.study.Study;
import tompkins.study.StudyData;
import tompkins.study.StudyKind;
import tompkins.study.StudyPage;
import tompkins.study.StudySetup;
import tompkins.study.Trial;

/** Charts speed against accuracy. */
@Command(
        header = "Charts speed against accuracy.",
        description =
                "Measures methods against each other and writes charts, figures and"
                        + " what they show. A study that was stopped with Ctrl-C continues where it stopped when it is started again.")
final class StudyCommand extends ProgramCommand {

    private static final String ALL = "all";
    private static final String PAGE_OF_ALL = "speed-and-accuracy";

    @Parameters(
            index = "0",
            paramLabel = "NAME",
            completionCandidates = Names.class,
            description = "${COMPLETION-CANDIDATES}")
    private String name;

    @Parameters(
            index = "1",
            arity = "0..1",
            paramLabel = "SCENE",
            description =
                    "scene file or saved photograph to measure instead of the program's own scenes (aperture, exposure,"
                            + " antialiasing, preview)")
    private Path scene;

    @Option(
            names = {"-o", "--output"},
            paramLabel = "FOLDER",
            description = "a folder for the page, and for a folder of charts and figures beside it, which is made if"
                    + " there is none; default: the current folder")
    private Path output;

    @Option(names = "--seed", paramLabel = "N", defaultValue = "1", description = "seed of everything that is random")
    private long seed;

    @Option(
            names = "--force",
            description = "replace figures of other settings or of another machine, and a page that is there")
    private boolean force;

    @Option(
            names = "--part",
            paramLabel = "I/N",
            description =
                    "measure each N-th point of the charts from I on, counted from 0; without it, the page is made of all parts")
    private Part part;

    @Mixin
    private ThreadsOption threads;

    @Mixin
    private SetOption option;

    private ProgressLine report;

    @Override
    public Integer call() throws Exception {
        List<StudyKind> kinds = kinds();
        Studio own = scene == null ? null : option.read(scene, List.of());
        if (own == null && !option.assignments().isEmpty()) {
            throw new MistakeException(SetOption.NAME + " changes SCENE, which is missing");
        }
        if (own != null) {
            kinds = requireScene(kinds);
        }
        Fonts.require();
        StudySetup setup = new StudySetup(seed, own);
        List<StudyKind> fitting = kinds;
        output = output == null ? NamedFile.currentFolder() : output;
        report = new ProgressLine(err());
        return OutputOption.inFolder(output, () -> threads.during(() -> study(fitting, setup)));
    }

    private int study(List<StudyKind> kinds, StudySetup setup) throws IOException {
        StudyPage page = page(kinds);
        Photographer.requireWritable(page.file());
        Map<StudyKind, Study> studies = new EnumMap<>(StudyKind.class);
        kinds.forEach(kind -> studies.put(kind, kind.study(setup)));
        if (!force) {
            refuseToReplace(studies, page);
        }
        boolean holds = true;
        for (StudyKind kind : studies.keySet()) {
            holds &= make(kind, studies.get(kind), page);
        }
        if (part == null) {
            out().println(page.write().toAbsolutePath());
        }
        return holds ? 0 : Failures.FAILURE;
    }

    private StudyPage page(List<StudyKind> kinds) throws IOException {
        if (kinds.size() == StudyKind.values().length) {
            return new StudyPage(output, PAGE_OF_ALL, StudyPage.introduction(SelfDescription.program()));
        }
        String names = kinds.stream().map(StudyKind::toString).collect(Collectors.joining(", "));
        return new StudyPage(output, kinds.size() == 1 ? names : PAGE_OF_ALL, "# Study: " + names);
    }

    private List<StudyKind> kinds() {
        if (name.equalsIgnoreCase(ALL)) {
            return List.of(StudyKind.values());
        }
        for (StudyKind kind : StudyKind.values()) {
            if (kind.toString().equalsIgnoreCase(name)) {
                return List.of(kind);
            }
        }
        throw new MistakeException(
                "NAME must be one of " + String.join(", ", new Names()) + "; was " + OptionValues.shown(name));
    }

    /** What can be studied: one thing, or all. */
    static final class Names implements Iterable<String> {

        @Override
        public Iterator<String> iterator() {
            return Stream.concat(Stream.of(StudyKind.values()).map(StudyKind::toString), Stream.of(ALL))
                    .iterator();
        }
    }

    private List<StudyKind> requireScene(List<StudyKind> kinds) {
        List<StudyKind> fitting = kinds.stream().filter(StudyKind::takesScene).toList();
        if (fitting.isEmpty()) {
            throw new MistakeException("the study " + name + " makes its own scenes; leave SCENE out, was " + scene);
        }
        return fitting;
    }

    /** Refuses to replace anything except what the same studies have made here before. */
    private void refuseToReplace(Map<StudyKind, Study> studies, StudyPage page) throws IOException {
        boolean madeBefore = false;
        for (StudyKind kind : studies.keySet()) {
            boolean hasFigures = Files.exists(page.dataOf(kind));
            madeBefore |= hasFigures;
            if (!hasFigures && part == null) {
                page.chartsOf(kind, studies.get(kind)).forEach(Photographer::requireFree);
            }
            Optional<Path> other = data(kind, studies.get(kind), page).holdingOther();
            if (other.isPresent()) {
                throw new MistakeException(
                        other.get()
                                + ": holds figures of other settings, another machine or another version; --force replaces them");
            }
        }
        if (!madeBefore && part == null) {
            Photographer.requireFree(page.file());
        }
    }

    private StudyData data(StudyKind kind, Study study, StudyPage page) {
        return new StudyData(kind, study, file(kind, page), SelfDescription.program());
    }

    private Path file(StudyKind kind, StudyPage page) {
        return part == null ? page.dataOf(kind) : page.dataOf(kind, part.index(), part.count());
    }

    /** Measures a study and puts it on the page; a part of it is measured alone. Says whether all is as it must be. */
    private boolean make(StudyKind kind, Study study, StudyPage page) throws IOException {
        List<Measurement> all = data(kind, study, page)
                .complete(own(study.trials()), (point, done, count) -> report.measured(kind, point, done, count));
        report.clear();
        if (part != null) {
            out().println(file(kind, page).toAbsolutePath());
            return true;
        }
        Conclusion conclusion = page.add(kind, study, all);
        out().println(conclusion.answer());
        boolean holds = true;
        for (Conclusion.Finding finding : conclusion.findings()) {
            out().println((finding.holds() ? "" : "BROKEN: ") + finding.sentence());
            holds &= finding.holds();
        }
        return holds;
    }

    /** The trials of the part; those that share some work stay together. */
    private List<Trial> own(List<Trial> trials) {
        if (part == null) {
            return trials;
        }
        Set<Object> works =
                Set.copyOf(part.of(trials.stream().map(Trial::work).distinct().toList()));
        return trials.stream().filter(trial -> works.contains(trial.work())).toList();
    }
}

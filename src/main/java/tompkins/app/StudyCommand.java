package tompkins.app;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import tompkins.file.PendingFile;
import tompkins.image.Fonts;
import tompkins.io.SelfDescription;
import tompkins.property.MistakeException;
import tompkins.study.Chart;
import tompkins.study.ChartDrawing;
import tompkins.study.Conclusion;
import tompkins.study.Study;
import tompkins.study.StudyData;
import tompkins.study.StudyKind;
import tompkins.study.StudyPage;
import tompkins.study.StudyPoint;
import tompkins.study.Trial;

/** Charts speed against accuracy. */
@Command(
        header = "Charts speed against accuracy.",
        description = "Measures methods against each other and writes charts, figures and"
                + " what they show. After Ctrl-C, studies that are done are not measured again.")
final class StudyCommand extends ProgramCommand {

    private static final String ALL = "all";
    private static final String PAGE_OF_ALL = "speed-and-accuracy";

    @Parameters(
            index = "0",
            paramLabel = "NAME",
            completionCandidates = Names.class,
            description = "${COMPLETION-CANDIDATES}")
    private String name;

    @Option(
            names = {"-o", "--output"},
            paramLabel = "FOLDER",
            description = "folder for the page and its charts, made if there is none; default: the current folder")
    private Path output;

    @Option(names = "--seed", paramLabel = "N", defaultValue = "1", description = "seed of everything that is random")
    private long seed;

    @Option(names = "--force", description = "measure again, and replace the page and figures that are there")
    private boolean force;

    @Mixin
    private ThreadsOption threads;

    private ProgressLine report;

    @Override
    public Integer call() throws Exception {
        List<StudyKind> kinds = kinds();
        String title = kinds.size() == 1 ? kinds.get(0).toString() : PAGE_OF_ALL;
        Fonts.require();
        output = output == null ? NamedFile.currentFolder() : output;
        report = new ProgressLine(err());
        return OutputOption.inFolder(
                output,
                () -> OutputOption.inFolder(output.resolve(title), () -> threads.during(() -> study(kinds, title))));
    }

    private int study(List<StudyKind> kinds, String title) throws IOException {
        Path file = output.resolve(title + ".md");
        Path folder = output.resolve(title);
        Photographer.requireWritable(file);
        List<Study> studies = kinds.stream().map(kind -> kind.study(seed)).toList();
        if (!force) {
            refuseToReplace(kinds, studies, file, folder);
        }
        List<StudyData> all = new ArrayList<>();
        for (int i = 0; i < studies.size(); i++) {
            all.add(figures(kinds.get(i), studies.get(i), folder.resolve(kinds.get(i) + ".csv")));
        }
        StudyPage page = new StudyPage(title, kinds.size() == 1 ? "# Study: " + title : StudyPage.introduction(all));
        boolean holds = true;
        for (int i = 0; i < studies.size(); i++) {
            for (Chart chart : studies.get(i).charts()) {
                byte[] png = ChartDrawing.png(chart, all.get(i).measurements());
                PendingFile.save(folder.resolve(chart.file(kinds.get(i))), true, out -> out.write(png));
            }
            holds &= tell(page.add(kinds.get(i), studies.get(i), all.get(i)));
        }
        PendingFile.save(file, true, out -> out.write(page.text().getBytes(StandardCharsets.UTF_8)));
        out().println(file.toAbsolutePath());
        return holds ? 0 : Failures.FAILURE;
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

    /** Refuses to replace anything except what the same studies have made here before. */
    private static void refuseToReplace(List<StudyKind> kinds, List<Study> studies, Path page, Path folder)
            throws IOException {
        boolean madeBefore = false;
        for (int i = 0; i < studies.size(); i++) {
            StudyKind kind = kinds.get(i);
            Path figures = folder.resolve(kind + ".csv");
            if (!Files.exists(figures)) {
                studies.get(i).charts().forEach(chart -> Photographer.requireFree(folder.resolve(chart.file(kind))));
            } else if (known(kind, studies.get(i), figures).isEmpty()) {
                throw new MistakeException(
                        figures
                                + ": holds figures of other settings, another machine or another version; --force replaces them");
            } else {
                madeBefore = true;
            }
        }
        if (!madeBefore) {
            Photographer.requireFree(page);
        }
    }

    /** The figures that this program has measured here before, with the same settings. */
    private static Optional<StudyData> known(StudyKind kind, Study study, Path file) throws IOException {
        StudyData.Origin own = StudyData.Origin.here(kind, study, SelfDescription.program());
        return StudyData.read(file).filter(data -> data.origin().equals(own));
    }

    /** The figures of a study, as its file holds them; they are measured unless it holds them already. */
    private StudyData figures(StudyKind kind, Study study, Path file) throws IOException {
        if (force || !Files.exists(file)) {
            List<StudyPoint> measured = new ArrayList<>();
            List<Trial> trials = study.trials();
            for (Trial trial : trials) {
                StudyPoint point = trial.measure();
                measured.add(point);
                report.begin(String.format(
                        Locale.ROOT,
                        "%s %d/%d: %s, %s, %.6g",
                        kind,
                        measured.size(),
                        trials.size(),
                        point.problem(),
                        point.method(),
                        point.setting()));
            }
            new StudyData(StudyData.Origin.here(kind, study, SelfDescription.program()), measured).write(file);
            report.clear();
        }
        return known(kind, study, file).orElseThrow();
    }

    /** Prints what follows from a study, and says whether all is as it must be. */
    private boolean tell(Conclusion conclusion) {
        out().println(conclusion.answer());
        boolean holds = true;
        for (Conclusion.Finding finding : conclusion.findings()) {
            out().println((finding.holds() ? "" : "BROKEN: ") + finding.sentence());
            holds &= finding.holds();
        }
        return holds;
    }
}

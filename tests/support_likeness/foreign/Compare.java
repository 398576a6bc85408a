import de.jplag.JPlag;
import de.jplag.JPlagComparison;
import de.jplag.options.JPlagOptions;
import de.jplag.options.SimilarityMetric;
import java.io.File;
import java.util.Set;

/** Prints every pair of a folder of token files with its likeness, as JPlag has it. */
public class Compare {
    public static void main(String[] args) throws Exception {
        JPlagOptions options = new JPlagOptions(
                new de.jplag.text.Language(), Set.of(new File(args[0])), Set.of())
            .withMinimumTokenMatch(9)
            .withMaximumNumberOfComparisons(JPlagOptions.SHOW_ALL_COMPARISONS)
            .withSimilarityMetric(SimilarityMetric.AVG)
            .withBaseCodeSubmissionDirectory(new File(args[1]));
        StringBuilder told = new StringBuilder("[");
        for (JPlagComparison pair : new JPlag(options).run().getAllComparisons()) {
            told.append(told.length() > 1 ? "," : "").append("[\"")
                .append(pair.firstSubmission().getName()).append("\",\"")
                .append(pair.secondSubmission().getName()).append("\",")
                .append(pair.similarity()).append("]");
        }
        System.out.println(told.append("]"));
    }
}

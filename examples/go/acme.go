// SPDX-License-Identifier: MIT-0

// A subject in Go, one file without modules: straight lines of RS274 in millimetres, absolute (G0 and G1 with X, Y, Z
// and F, M2). Numbers stay the text that they were, so that nothing is rounded. Without M2 the last line alarms. Any
// other word, or a profile that is not the default one, is not supported: exit 3.
// It is called as: acme --dialect rs274 --profile FILE.json
package main

import (
	"bufio"
	"fmt"
	"io"
	"os"
	"regexp"
	"strings"
)

var word = regexp.MustCompile(`^([GXYZFM])([-+]?)([0-9]*)(\.?)([0-9]*)`)

type machine struct {
	out    *bufio.Writer
	motion string
	feed   string
}

func (m *machine) stop(status int) {
	m.out.Flush()
	os.Exit(status)
}

func (m *machine) alarm(class string, b int) {
	fmt.Fprintf(m.out, "{\"k\":\"alarm\",\"class\":%q,\"b\":%d}\n", class, b)
	m.stop(1)
}

// The words of a line, letter and number; what this example does not read ends it.
func (m *machine) words(line string) [][2]string {
	text := strings.ToUpper(strings.NewReplacer(" ", "", "\t", "").Replace(line))
	var words [][2]string
	for text != "" {
		found := word.FindStringSubmatch(text)
		if found == nil || found[3]+found[5] == "" {
			m.stop(3)
		}
		number := strings.TrimPrefix(found[2], "+") + found[3]
		if found[3] == "" {
			number += "0"
		}
		if found[5] != "" {
			number += "." + found[5]
		}
		words = append(words, [2]string{found[1], number})
		text = text[len(found[0]):]
	}
	return words
}

// Executes one line; true at the end of the program.
func (m *machine) block(line string, b int) bool {
	var to []string
	seen := map[string]bool{}
	ends := false
	for _, w := range m.words(line) {
		letter, number := w[0], w[1]
		if seen[letter] {
			m.stop(3)
		}
		seen[letter] = true
		switch {
		case letter == "G" && number == "0":
			m.motion = "rapid"
		case letter == "G" && number == "1":
			m.motion = "feed"
		case letter == "M" && number == "2":
			ends = true
		case letter == "F" && !strings.HasPrefix(number, "-"):
			m.feed = number
		case letter == "X" || letter == "Y" || letter == "Z":
			to = append(to, fmt.Sprintf("%q:%q", strings.ToLower(letter), number))
		default:
			m.stop(3)
		}
	}
	if len(to) > 0 || seen["G"] {
		switch {
		case m.motion == "":
			m.alarm("missing-word", b)
		case m.motion == "feed" && !strings.ContainsAny(m.feed, "123456789"):
			m.alarm("feed-missing", b)
		case len(to) > 0:
			speed := ""
			if m.motion == "feed" {
				speed = fmt.Sprintf(",\"f\":%q", m.feed)
			}
			fmt.Fprintf(m.out, "{\"k\":%q,\"b\":%d,\"to\":{%s}%s}\n", m.motion, b, strings.Join(to, ","), speed)
		}
	}
	if ends {
		fmt.Fprintf(m.out, "{\"k\":\"m\",\"b\":%d,\"m\":2}\n", b)
	}
	return ends
}

func main() {
	m := &machine{out: bufio.NewWriter(os.Stdout)}
	profile := ""
	for i, argument := range os.Args {
		if argument == "--profile" && i+1 < len(os.Args) {
			profile = os.Args[i+1]
		}
	}
	text, err := os.ReadFile(profile)
	if err != nil || strings.TrimSpace(string(text)) != "{}" {
		m.stop(3)
	}
	program, _ := io.ReadAll(os.Stdin)
	lines := strings.Split(strings.TrimSuffix(strings.NewReplacer("\r\n", "\n", "\r", "\n").Replace(string(program)), "\n"), "\n")
	for i, line := range lines {
		if m.block(line, i+1) {
			m.stop(0)
		}
	}
	m.alarm("program-end", len(lines))
}
